package org.sami.crw.cli.analysis;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Locale;
import java.util.Optional;
import org.sami.petri.coverability.CoverabilityAnswers;
import org.sami.petri.coverability.CoverabilityGraph;
import org.sami.petri.coverability.CoverabilitySet;
import org.sami.petri.coverability.Omega;
import org.sami.petri.net.PetriNet;
import org.sami.petri.structure.IntegerVector;
import org.sami.petri.structure.StructuralProof;

/** Facts from structure as members of a JSON object; docs/command-line.md lists them. */
final class StructureJson {
    private StructureJson() {}

    static void put(ObjectNode object, StructureFacts facts) {
        PetriNet net = facts.net();
        object.put("net", net.name()).put("places", net.placeCount()).put("transitions", net.transitionCount());
        ArrayNode sums = object.putArray("placeInvariants");
        for (IntegerVector invariant : facts.placeInvariants().invariants()) {
            ObjectNode one = sums.addObject().put("value", invariant.times(net.initialMarking()));
            put(one.putObject("weights"), net, invariant);
        }
        facts.basis().ifPresent(basis -> {
            ArrayNode list = object.putArray("placeInvariantBasis");
            basis.forEach(invariant -> put(list.addObject(), net, invariant));
        });
        ArrayNode rounds = object.putArray("transitionInvariants");
        for (IntegerVector invariant : facts.transitionInvariants().invariants()) {
            ObjectNode counts = rounds.addObject();
            for (int i = 0; i < invariant.size(); i++) {
                counts.put(net.transitionId(invariant.indexAt(i)), invariant.valueAt(i));
            }
        }
        object.put(
                "allInvariants",
                facts.placeInvariants().complete()
                        && facts.transitionInvariants().complete());
        put(object, "neverStops", facts.neverStops());
        put(object, "live", facts.isLive());
        ObjectNode most = object.putObject("mostTokens");
        for (int place = 0; place < net.placeCount(); place++) {
            String id = net.placeId(place);
            facts.mostTokens(place).ifPresent(tokens -> most.put(id, tokens));
        }
        facts.coverability().ifPresent(answers -> {
            ObjectNode member = object.putObject("coverability");
            put(member, net, answers);
            ArrayNode dead = member.putArray("neverFires");
            facts.neverFiring().forEach(transition -> dead.add(net.transitionId(transition)));
            putGraph(member, net, answers.set());
        });
    }

    private static void put(ObjectNode weights, PetriNet net, IntegerVector invariant) {
        for (int i = 0; i < invariant.size(); i++) {
            weights.put(net.placeId(invariant.indexAt(i)), invariant.valueAt(i));
        }
    }

    private static void put(ObjectNode object, String what, Optional<StructuralProof> proof) {
        proof.ifPresent(given -> {
            ObjectNode member = object.putObject(what);
            member.put("method", given.method().words());
            ArrayNode lines = member.putArray("proof");
            given.words().forEach(lines::add);
        });
    }

    private static void put(ObjectNode object, PetriNet net, CoverabilityAnswers answers) {
        object.put("complete", answers.set().isComplete())
                .put("end", answers.set().end().name().toLowerCase(Locale.ROOT))
                .put("markings", answers.set().size())
                .put("searched", answers.set().searched())
                .put("words", answers.words(net));
        ArrayNode unbounded = object.putArray("unbounded");
        answers.unbounded(net).forEach(place -> unbounded.add(net.placeId(place)));
        ArrayNode unproved = object.putArray("unprovedExactPlaces");
        answers.unproved().forEach(place -> unproved.add(net.placeId(place)));
    }

    /** The markings by place, without empty places and with ω for any number of tokens, and the edges as from, transition, to. */
    private static void putGraph(ObjectNode object, PetriNet net, CoverabilitySet set) {
        ArrayNode nodes = object.putArray("set");
        for (int number = 0; number < set.size(); number++) {
            ObjectNode node = nodes.addObject();
            int[] marking = set.marking(number);
            for (int place = 0; place < marking.length; place++) {
                if (marking[place] == Omega.OMEGA) {
                    node.put(net.placeId(place), "ω");
                } else if (marking[place] > 0) {
                    node.put(net.placeId(place), marking[place]);
                }
            }
        }
        ArrayNode edges = object.putArray("edges");
        for (CoverabilityGraph.Edge edge : set.graph().edges()) {
            edges.addArray()
                    .add(edge.from())
                    .add(net.transitionId(edge.transition()))
                    .add(edge.to());
        }
    }
}
