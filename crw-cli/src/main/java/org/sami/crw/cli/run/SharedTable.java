package org.sami.crw.cli.run;

import java.io.IOException;
import java.io.PrintWriter;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import org.sami.crw.sim.experiment.table.RunRow;
import org.sami.crw.sim.experiment.table.TableRun;
import org.sami.journal.postgres.PostgresAddress;

/**
 * How the repetitions of a table are divided among machines.
 *
 * @param address where they stand
 * @param settings all that they depend on
 */
record SharedTable(PostgresAddress address, Map<String, String> settings, PrintWriter err) {
    /** Makes those that are missing, with the other machines, and gives all rows. */
    List<RunRow> rows(String experiment, TableRun run, int threads, BooleanSupplier stop) throws IOException {
        return new SharedExperiment(address, "repetitions", err)
                .rows(experiment, run.portions(), settings, threads, stop);
    }
}
