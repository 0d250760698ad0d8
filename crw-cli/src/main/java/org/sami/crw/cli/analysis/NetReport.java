package org.sami.crw.cli.analysis;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.ProgressDisplay;
import org.sami.crw.cli.output.StopOnInterrupt;
import org.sami.crw.cli.output.Terminal;
import org.sami.crw.cli.output.UsageFault;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.ReachabilitySearch;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.graph.SearchSettings;
import org.sami.petri.net.PetriNet;
import org.sami.petri.pnml.PnmlReading;
import org.sami.petri.query.NetQuery;
import org.sami.petri.query.QueryFaultException;
import org.sami.petri.query.QueryMeans;
import org.sami.petri.query.QueryParser;
import org.sami.petri.query.QueryRunner;

/** What {@code crw analyse} says about a Petri net that was read: its findings, the answers to queries, or what its structure tells. For one thread, once. */
final class NetReport {
    private final String name;
    private final PnmlReading reading;
    private final SearchBudget budget;
    private final SearchOptions options;
    private final boolean json;
    private final PrintWriter out;
    private final PrintWriter err;

    /** A report on a net that the user calls {@code name}; hints and progress go to {@code err}. */
    NetReport(
            String name,
            PnmlReading reading,
            SearchBudget budget,
            SearchOptions options,
            boolean json,
            PrintWriter out,
            PrintWriter err) {
        this.name = name;
        this.reading = reading;
        this.budget = budget;
        this.options = options;
        this.json = json;
        this.out = out;
        this.err = err;
    }

    /**
     * Prints the answers to queries, without one what a search of all markings finds.
     *
     * @return the exit code
     */
    int answers(List<String> queries) {
        Optional<PetriNet> net = reading.net();
        if (net.isEmpty()) {
            return unread();
        }
        List<NetQuery> asked = parsed(net.get(), queries);
        SearchBudget fitted = HeapRoom.fitted(budget, asked.size() > 1, err);
        if (!json) {
            NetArgument.print(out, name, reading.findings());
            out.println(net.get());
        }
        List<NetAnalysis> analyses = analyses(net.get(), asked, queries, fitted);
        print(analyses, queries.isEmpty());
        if (analyses.stream().anyMatch(NetAnalysis::hasFound)) {
            return ExitCode.FINDINGS;
        }
        return analyses.stream().anyMatch(NetAnalysis::isOpen) ? ExitCode.RUNNING : ExitCode.OK;
    }

    /**
     * Prints what follows from the arcs alone.
     *
     * @return the exit code
     */
    int structure() {
        Optional<PetriNet> net = reading.net();
        return net.isEmpty() ? unread() : structure(net.get(), HeapRoom.fitted(budget, true, err));
    }

    private int unread() {
        if (json) {
            out.println(AnalysisJson.of(name, reading.findings()).toPrettyString());
        } else {
            NetArgument.print(out, name, reading.findings());
        }
        return ExitCode.FINDINGS;
    }

    private int structure(PetriNet net, SearchBudget fitted) {
        ProgressDisplay progress = new ProgressDisplay(err, Terminal.onStandardError(), System::nanoTime);
        StructureFacts facts;
        try (StopOnInterrupt stop = new StopOnInterrupt()) {
            facts = StructureFacts.of(net, fitted, SearchProgress.watch(progress, stop), stop);
            progress.end();
        }
        if (json) {
            ObjectNode object = AnalysisJson.of(name, reading.findings());
            StructureJson.put(object, facts);
            out.println(object.toPrettyString());
        } else {
            NetArgument.print(out, name, reading.findings());
            out.println(net);
            new StructureText(out, facts).print();
        }
        return facts.isOpen() ? ExitCode.RUNNING : ExitCode.OK;
    }

    private static List<NetQuery> parsed(PetriNet net, List<String> queries) {
        List<NetQuery> parsed = new ArrayList<>();
        for (String query : queries) {
            try {
                parsed.add(QueryParser.query(net, query));
            } catch (QueryFaultException fault) {
                throw new UsageFault("--query '" + query + "', " + fault.words());
            }
        }
        return parsed;
    }

    private List<NetAnalysis> analyses(PetriNet net, List<NetQuery> asked, List<String> queries, SearchBudget fitted) {
        ProgressDisplay progress = new ProgressDisplay(err, Terminal.onStandardError(), System::nanoTime);
        List<NetAnalysis> analyses = new ArrayList<>();
        try (StopOnInterrupt stop = new StopOnInterrupt()) {
            GraphWatch watch = SearchProgress.watch(progress, stop);
            QueryMeans means = options.means(net);
            if (asked.isEmpty()) {
                SearchSettings whole = SearchSettings.within(fitted);
                analyses.add(NetAnalysis.of(ReachabilitySearch.explore(
                        net, means.symmetry().map(whole::withSymmetry).orElse(whole), watch, System::nanoTime)));
            }
            QueryRunner runner = new QueryRunner(net, fitted, means, watch, System::nanoTime);
            ProofsBeforeSearch proofs = new ProofsBeforeSearch(net, fitted, watch, stop);
            for (int i = 0; i < asked.size(); i++) {
                NetQuery query = asked.get(i);
                String text = queries.get(i);
                Optional<NetAnalysis> proved = options.asksStructure() ? proofs.answer(text, query) : Optional.empty();
                analyses.add(proved.orElseGet(() -> NetAnalysis.of(text, query, runner.answer(query))));
            }
            progress.end();
        }
        return analyses;
    }

    /** Without queries, the members of the whole graph stand in the object itself; else there is an object for each query. */
    private void print(List<NetAnalysis> analyses, boolean isWhole) {
        if (!json) {
            analyses.forEach(analysis -> new AnalysisText(out, analysis).print());
            return;
        }
        ObjectNode object = AnalysisJson.of(name, reading.findings());
        if (isWhole) {
            AnalysisJson.put(object, analyses.get(0));
        } else {
            ArrayNode list = object.putArray("queries");
            analyses.forEach(analysis -> AnalysisJson.put(list.addObject(), analysis));
        }
        out.println(object.toPrettyString());
    }
}
