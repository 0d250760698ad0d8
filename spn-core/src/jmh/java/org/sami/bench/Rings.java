package org.sami.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.engine.Engine;
import org.sami.spn.model.Action;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.Match;
import org.sami.spn.model.Mode;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.model.WaitFor;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.TokenNeed;
import org.sami.spn.vocabulary.Vocabulary;

/** Ring-shaped plans: every place sends {@code Do}, every transition takes {@code Done} and moves on to the next place. */
final class Rings {
    private Rings() {}

    /** One generic token goes round. */
    static Engine generic(int places) {
        return engine(plan(
                places,
                WaitFor.EACH,
                InRequirement.of(TokenKind.GENERIC, Match.AT_LEAST, 1),
                OutRequirement.of(Action.TAKE, 1, TokenKind.GENERIC)));
    }

    /** Each robot goes round by itself. */
    static Engine robots(int places) {
        return engine(relevant(places, WaitFor.EACH));
    }

    /** All robots go round together: each place waits for all. */
    static Engine together(int places) {
        return engine(relevant(places, WaitFor.ALL));
    }

    private static Plan relevant(int places, WaitFor waitFor) {
        return plan(
                places,
                waitFor,
                InRequirement.allRelevant(),
                OutRequirement.of(Action.TAKE, OutRequirement.ALL, TokenKind.RELEVANT));
    }

    private static Engine engine(Plan plan) {
        Vocabulary vocabulary = new Vocabulary(
                "bench",
                List.of(),
                List.of(event("Do", Direction.OUTPUT, List.of("Done")), event("Done", Direction.INPUT, List.of())),
                List.of(),
                List.of());
        return new Engine(vocabulary, new Project("bench", "bench", "bench", List.of(), List.of(), List.of(plan)));
    }

    private static EventType event(String name, Direction direction, List<String> answers) {
        return new EventType(
                name,
                List.of(),
                direction,
                List.of(),
                TokenNeed.NONE,
                answers,
                EventRole.NONE,
                Set.of(),
                Optional.empty(),
                name,
                "");
    }

    private static Plan plan(int size, WaitFor waitFor, InRequirement in, OutRequirement out) {
        List<Place> places = new ArrayList<>();
        List<Transition> transitions = new ArrayList<>();
        List<InEdge> ins = new ArrayList<>();
        List<OutEdge> outs = new ArrayList<>();
        for (int i = 0; i < size; i++) {
            OutputEventSpec output = new OutputEventSpec("p" + i + ".Do", "Do", Map.of(), Map.of(), List.of());
            places.add(
                    new Place("p" + i, "", i == 0, false, false, Mode.NOMINAL, List.of(output), List.of(), List.of()));
            InputEventSpec input = new InputEventSpec("t" + i + ".Done", "Done", Map.of(), Map.of(), List.of());
            transitions.add(new Transition("t" + i, "", Mode.NOMINAL, waitFor, List.of(input)));
            ins.add(new InEdge("i" + i, "p" + i, "t" + i, Mode.NOMINAL, List.of(in)));
            outs.add(new OutEdge("o" + i, "t" + i, "p" + (i + 1) % size, Mode.NOMINAL, List.of(out)));
        }
        return new Plan(
                "ring",
                "ring",
                "",
                places,
                transitions,
                ins,
                outs,
                List.of(),
                List.of(),
                List.of(),
                Map.of(),
                List.of(),
                List.of());
    }
}
