package org.sami.crw.cli.analysis;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Locale;
import org.sami.petri.graph.ReachabilityGraph;
import org.sami.petri.net.PetriNet;
import org.sami.petri.query.QueryAnswer.NetVerdict;
import org.sami.spn.plannet.PlanMarking;
import org.sami.spn.planspace.PlanQueryAnswer;
import org.sami.spn.planspace.PlanWitness;

/** An analysis of a plan as a JSON object for programs; docs/command-line.md lists its members. */
final class PlanAnalysisJson {
    private PlanAnalysisJson() {}

    static ObjectNode of(String source, PlanAnalysis analysis) {
        ObjectNode object = JsonNodeFactory.instance.objectNode();
        PetriNet net = analysis.plan().net().net();
        object.put("source", source)
                .put("plan", analysis.plan().plan().id())
                .put("boats", analysis.plan().net().request().robots().size())
                .put("places", net.placeCount())
                .put("transitions", net.transitionCount())
                .put("boatsCounted", analysis.plan().net().isCounted())
                .put("boatsPresent", analysis.plan().net().isPresent());
        ArrayNode open = object.putArray("abstractions");
        analysis.plan()
                .net()
                .abstractions()
                .forEach(a -> open.addObject()
                        .put("kind", a.kind().name().toLowerCase(Locale.ROOT))
                        .put("where", a.where())
                        .put("text", a.text()));
        analysis.graph().ifPresent(graph -> putGraph(object, graph));
        analysis.facts().ifPresent(facts -> {
            ArrayNode gathering = object.putArray("notCounted");
            facts.gathering().forEach(gathering::add);
            ArrayNode never = object.putArray("neverFired");
            facts.neverFired().forEach(never::add);
            ObjectNode most = object.putObject("mostBoats");
            facts.mostRobots().forEach(most::put);
        });
        ArrayNode queries = object.putArray("queries");
        analysis.answers().forEach(answer -> put(queries.addObject(), answer, analysis.kind()));
        return object;
    }

    private static void putGraph(ObjectNode object, ReachabilityGraph graph) {
        SearchSpeed speed = SearchSpeed.of(graph);
        object.put("states", graph.states())
                .put("edges", graph.edges())
                .put("seconds", speed.seconds())
                .put("statesPerSecond", speed.statesPerSecond())
                .put("bytesPerState", speed.bytesPerState())
                .put("complete", graph.isComplete())
                .put("end", graph.end().name().toLowerCase(Locale.ROOT));
    }

    private static void put(ObjectNode object, PlanQueryAnswer answer, PlanAnalysis.Kind kind) {
        object.put("query", answer.query().text());
        if (kind == PlanAnalysis.Kind.SAVED) {
            object.put("name", answer.query().name())
                    .put("expect", answer.query().expected().name().toLowerCase(Locale.ROOT))
                    .put("result", answer.result().name().toLowerCase(Locale.ROOT));
        }
        object.put("verdict", answer.verdict().name().toLowerCase(Locale.ROOT))
                .put("answer", answer.words())
                .put("certain", !answer.mayBe() && answer.verdict() != NetVerdict.UNKNOWN)
                .put("states", answer.states())
                .put("seconds", answer.nanos() / 1e9);
        if (!answer.proof().isEmpty()) {
            ArrayNode proof = object.putArray("proof");
            answer.proof().forEach(proof::add);
        }
        answer.witness().ifPresent(witness -> put(object, witness));
    }

    private static void put(ObjectNode object, PlanWitness witness) {
        ArrayNode run = object.putArray("witness");
        witness.words().forEach(run::add);
        ObjectNode marking = object.putObject("marking");
        PlanMarking end = witness.end();
        end.tokens().forEach((place, tokens) -> {
            ObjectNode here = marking.putObject(place);
            tokens.forEach(here::put);
        });
        object.put("onEngine", witness.steps().isPresent());
        witness.steps()
                .ifPresent(steps -> object.put("engineSteps", steps.steps().size()));
    }
}
