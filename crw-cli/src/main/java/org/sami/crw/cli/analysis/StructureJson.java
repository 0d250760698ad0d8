package org.sami.crw.cli.analysis;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Locale;
import java.util.Optional;
import org.sami.petri.coverability.CoverabilityAnswers;
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
            ObjectNode weights = one.putObject("weights");
            for (int i = 0; i < invariant.size(); i++) {
                weights.put(net.placeId(invariant.indexAt(i)), invariant.valueAt(i));
            }
        }
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
        facts.coverability().ifPresent(answers -> put(object.putObject("coverability"), net, answers));
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
}
