# parsim2d: the words of the lesson. `make` builds ./parSim2D.
EXEC   = parSim2D
CARGO  = cargo
# Where cargo builds.
TARGET = $(or $(CARGO_TARGET_DIR),target)
ARGS   =                # e.g. make run ARGS="-n 1000 --radius 5e-4"
# What `make live` shows, unless ARGS say otherwise: discs large enough, and slow enough, to be seen.
LIVE   = $(if $(findstring --preset,$(ARGS))$(findstring .toml,$(ARGS)),,--preset guide-listing) \
         $(if $(findstring --slowdown,$(ARGS)),,--slowdown 40)

$(EXEC): Cargo.toml Cargo.lock $(shell find src -name '*.rs')
	$(CARGO) build --release
	cp $(TARGET)/release/parsim2d $(EXEC)

.PHONY: run live plot test check hash-matrix kill-test corruption-test disk-full-test proof bench scaling costs peers clean
run: $(EXEC)            # simulate; writes out.txt, trajectory.txt, energy.csv
	./$(EXEC) $(ARGS)

live: $(EXEC)           # simulate slowly and watch in gnuplot: a fall takes 4 s; closing the window or Ctrl-C ends both
	./$(EXEC) $(LIVE) -q $(ARGS) & run=$$!; \
	trap 'kill $$run 2>/dev/null; wait $$run' EXIT; gnuplot plot/loop.plot

plot:                   # pictures of the last run: replay.gif, energy.png, velocity.png
	gnuplot -e "gif='replay.gif'" plot/replay.plot
	gnuplot -e "png='energy.png'" plot/energy.plot
	gnuplot -e "png='velocity.png'" plot/velocity.plot

test:                   # all tests
	$(CARGO) test

check:                  # what CI checks
	bash .ci/run

hash-matrix: $(EXEC)    # same bits on 1 to 8 threads, for dev and release builds, for any output
	$(CARGO) build
	sh tests/hash_matrix.sh $(TARGET)/debug/parsim2d ./$(EXEC)

kill-test:              # 200 kills with SIGKILL at random moments; each run must end with the same bytes
	PARSIM2D_KILLS=200 $(CARGO) test --test all restart::runs_killed -- --nocapture

corruption-test:        # 10,000 damaged checkpoints, none may be accepted
	PARSIM2D_CORRUPTIONS=10000 $(CARGO) test --test all checkpoint_file:: -- --nocapture

proof:                  # the grader against 106 programs of which it is known what is wrong; right ones with 5 seeds
	PARSIM2D_PROOF=all $(CARGO) test --test all grade_submissions:: -- --nocapture

disk-full-test: $(EXEC) # a tmpfs that fills up during output and during a checkpoint; wants root
	sh tests/disk_full.sh $(CURDIR)/$(EXEC)

bench: $(EXEC)          # how fast is this machine? writes bench/<machine>/<date>.csv
	sh bench/run.sh ./$(EXEC)

scaling: $(EXEC)        # what threads bring
	sh bench/scaling.sh ./$(EXEC)

costs: $(EXEC)          # what ledger, frames and progress bar take
	sh bench/costs.sh ./$(EXEC)

peers: $(EXEC)          # beside LAMMPS (apt-get install lammps), as a table
	sh bench/peers/run.sh ./$(EXEC) --markdown

clean:                  # what runs, plots and builds wrote
	rm -f $(EXEC) out.txt trajectory.txt energy.csv last-run.toml failure.json *.tmp parsim2d.ckpt parsim2d.previous.ckpt .parsim2d.lock replay.gif energy.png velocity.png
	$(CARGO) clean
