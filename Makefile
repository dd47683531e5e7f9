# parsim2d: the words of the lesson. `make` builds ./parSim2D.
EXEC   = parSim2D
CARGO  = cargo
ARGS   =                # e.g. make run ARGS="-n 1000 --radius 5e-4"

$(EXEC): Cargo.toml Cargo.lock $(shell find src -name '*.rs')
	$(CARGO) build --release
	cp target/release/parsim2d $(EXEC)

.PHONY: run live plot test check bench clean
run: $(EXEC)            # simulate; writes out.txt, trajectory.txt, energy.csv
	./$(EXEC) $(ARGS)

live: $(EXEC)           # simulate slowly and watch in gnuplot; Ctrl-C ends both
	./$(EXEC) --slowdown 20 -q $(ARGS) & gnuplot plot/loop.plot; wait

plot:                   # pictures of the last run: replay.gif, energy.png, velocity.png
	gnuplot -e "gif='replay.gif'" plot/replay.plot
	gnuplot -e "png='energy.png'" plot/energy.plot
	gnuplot -e "png='velocity.png'" plot/velocity.plot

test:                   # all tests
	$(CARGO) test

check:                  # what CI checks
	bash .ci/run

bench: $(EXEC)          # how fast is this machine? writes bench/<machine>/<date>.csv
	sh bench/run.sh ./$(EXEC)

clean:                  # what runs, plots and builds wrote
	rm -f $(EXEC) out.txt trajectory.txt energy.csv last-run.toml failure.json *.tmp replay.gif energy.png velocity.png
	$(CARGO) clean
