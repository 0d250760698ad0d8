package org.sami.crw.cli.analysis;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Locale;
import org.sami.petri.graph.ReachabilityGraph;
import org.sami.petri.net.PetriNet;
import org.sami.petri.pnml.PnmlFinding;

/** An analysis as a JSON object for programs; docs/command-line.md lists its members. */
final class AnalysisJson {
    private AnalysisJson() {}

    /** What was found in the file; all there is where it has errors. */
    static ObjectNode of(String source, List<PnmlFinding> findings) {
        ObjectNode object = JsonNodeFactory.instance.objectNode();
        object.put("source", source);
        ArrayNode list = object.putArray("findings");
        for (PnmlFinding finding : findings) {
            list.addObject()
                    .put("severity", finding.severity().name().toLowerCase(Locale.ROOT))
                    .put("code", finding.code())
                    .put("line", finding.line())
                    .put("element", finding.element())
                    .put("message", finding.message());
        }
        return object;
    }

    /** Puts an analysis into an object. */
    static void put(ObjectNode object, NetAnalysis analysis) {
        PetriNet net = analysis.net();
        object.put("net", net.name()).put("places", net.placeCount()).put("transitions", net.transitionCount());
        analysis.graph().ifPresent(graph -> putSearch(object, graph));
        analysis.answer()
                .ifPresentOrElse(
                        answer -> putAnswer(object, answer),
                        () -> analysis.graph().ifPresent(graph -> putFacts(object, net, graph)));
        analysis.witness().ifPresent(run -> {
            ArrayNode witness = object.putArray("witness");
            run.ids(net).forEach(witness::add);
            putMarking(object, net, run.replay(net));
        });
    }

    private static void putSearch(ObjectNode object, ReachabilityGraph graph) {
        SearchSpeed speed = SearchSpeed.of(graph);
        object.put("states", graph.states())
                .put("edges", graph.edges())
                .put("seconds", speed.seconds())
                .put("statesPerSecond", speed.statesPerSecond())
                .put("bytesPerState", speed.bytesPerState())
                .put("complete", graph.isComplete())
                .put("end", graph.end().name().toLowerCase(Locale.ROOT));
    }

    private static void putAnswer(ObjectNode object, NetAnalysis.Answered answer) {
        object.put("query", answer.text())
                .put("verdict", answer.verdict().name().toLowerCase(Locale.ROOT))
                .put("answer", answer.words());
        answer.proof().ifPresent(proof -> {
            ArrayNode lines = object.putArray("proof");
            proof.words().forEach(lines::add);
        });
    }

    private static void putFacts(ObjectNode object, PetriNet net, ReachabilityGraph graph) {
        object.put("deadlocks", graph.deadlocks().size());
        ArrayNode dead = object.putArray("neverFired");
        graph.deadTransitions().forEach(transition -> dead.add(net.transitionId(transition)));
        ObjectNode most = object.putObject("mostTokens");
        for (int place = 0; place < net.placeCount(); place++) {
            most.put(net.placeId(place), graph.mostTokens(place));
        }
    }

    /** The first places that have tokens, and how many have. */
    private static void putMarking(ObjectNode object, PetriNet net, int[] marking) {
        ObjectNode first = object.putObject("marking");
        int marked = 0;
        for (int place = 0; place < marking.length; place++) {
            if (marking[place] > 0 && marked++ < AnalysisText.MOST_MARKED) {
                first.put(net.placeId(place), marking[place]);
            }
        }
        object.put("markedPlaces", marked);
    }
}
