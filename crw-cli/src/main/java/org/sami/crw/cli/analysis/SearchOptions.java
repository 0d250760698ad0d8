package org.sami.crw.cli.analysis;

import java.time.Duration;
import java.util.Optional;
import org.sami.crw.cli.option.SecondsConverter;
import org.sami.crw.cli.output.UsageFault;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.net.PetriNet;
import org.sami.petri.query.QueryMeans;
import org.sami.petri.symmetry.NetSymmetry;
import picocli.CommandLine.Option;

/** How far a search may go. */
final class SearchOptions {
    /** The heap has to hold the program as well; {@link HeapRoom} looks at what its net leaves. */
    private static final double MOST_OF_HEAP = 0.85;

    private static final double STANDARD_PART = 0.5;
    private static final int MEGABYTE = 1_000_000;

    @Option(
            names = "--budget",
            paramLabel = "STATES",
            defaultValue = "100000000",
            description = "How many states are looked at. Default: ${DEFAULT-VALUE}.")
    private int states;

    @Option(
            names = "--memory",
            paramLabel = "MB",
            defaultValue = "0",
            description = "How much memory the states may take, in megabytes; 0: half of what the program may use. "
                    + "Default: ${DEFAULT-VALUE}.")
    private int megabytes;

    @Option(
            names = "--time",
            paramLabel = "SECONDS",
            defaultValue = "0",
            converter = SecondsConverter.class,
            description = "How long each search may take, of which a query may need several; 0: as long as it takes."
                    + " Default: ${DEFAULT-VALUE}.")
    private long millis;

    @Option(
            names = "--no-reduction",
            description = "Answer questions about deadlocks from the whole graph, without stubborn sets.")
    private boolean isWhole;

    @Option(
            names = "--symmetry",
            description = "Count states as one that differ only by an exchange of equal components.")
    private boolean isSymmetric;

    @Option(names = "--search", description = "Search for every query, also where invariants would answer it.")
    private boolean isSearch;

    SearchBudget budget() {
        if (states < 1 || states > SearchBudget.MOST_STATES) {
            throw new UsageFault("--budget is 1 to " + SearchBudget.MOST_STATES + ", not " + states);
        }
        long heap = Runtime.getRuntime().maxMemory();
        long most = (long) (heap * MOST_OF_HEAP);
        long bytes = (long) megabytes * MEGABYTE;
        if (megabytes < 0 || bytes > most) {
            throw new UsageFault("--memory is 0 to " + most / MEGABYTE + ", not " + megabytes
                    + "; more by JAVA_OPTS=-Xmx" + Math.max(1, (long) (bytes / MOST_OF_HEAP) / MEGABYTE + 1) + "m");
        }
        return new SearchBudget(
                states,
                megabytes == 0 ? (long) (heap * STANDARD_PART) : bytes,
                millis == 0 ? Duration.ofDays(365) : Duration.ofMillis(millis));
    }

    QueryMeans means(PetriNet net) {
        return new QueryMeans(!isWhole, isSymmetric ? Optional.of(NetSymmetry.of(net)) : Optional.empty());
    }

    /** Whether the structure of the net is asked before a search. */
    boolean asksStructure() {
        return !isSearch;
    }
}
