package org.sami.spn.reference;

import java.util.List;
import java.util.Map;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;
import org.sami.spn.protocol.Token;

/** A scenario and where it went apart, for people. */
final class InWords {
    private InWords() {}

    static String of(Differential.Disagreement d) {
        StringBuilder text = new StringBuilder("Seed " + d.scenario().seed() + "\n");
        d.scenario().project().plans().forEach(plan -> text.append(plan(plan)));
        text.append("Inputs\n");
        Subject interpreter = Differential.interpreter(d.scenario().project());
        for (int i = 0; i <= d.index() && i < d.scenario().inputs().size(); i++) {
            Scenario.Timed timed = d.scenario().inputs().get(i);
            interpreter.step(timed.nowMillis(), timed.input());
            text.append("  %d ms %s%n      interpreter then: %s%n"
                    .formatted(timed.nowMillis(), timed.input(), markings(interpreter.markings())));
        }
        return text.append("They differ in\n").append(d.what()).append("\n").toString();
    }

    private static String markings(Map<Long, Map<String, List<Token>>> markings) {
        StringBuilder text = new StringBuilder();
        markings.forEach((mission, marking) -> {
            text.append(" [").append(mission);
            marking.forEach((place, tokens) -> text.append(' ')
                    .append(place)
                    .append('=')
                    .append(tokens.stream().map(RandomInputs::word).toList()));
            text.append(']');
        });
        return text.toString();
    }

    private static String plan(Plan plan) {
        StringBuilder text = new StringBuilder("Plan " + plan.id() + " tasks " + plan.tasks() + "\n");
        for (Place p : plan.places()) {
            text.append("  ").append(p.id()).append(p.start() ? " start" : "");
            text.append(p.end() ? (p.endsSharedInstance() ? " end (ends shared)" : " end") : "");
            p.outputs()
                    .forEach(o -> text.append(" ")
                            .append(o.type())
                            .append(o.fields().isEmpty() ? "" : o.fields())
                            .append(o.writes().isEmpty() ? "" : " writes " + o.writes())
                            .append(o.markups().isEmpty() ? "" : o.markups()));
            p.subMissions()
                    .forEach(s -> text.append(s.shared() ? " static " : " dynamic ")
                            .append(s.plan())
                            .append(s.tasks().isEmpty() ? "" : " tasks " + s.tasks())
                            .append(s.variables().isEmpty() ? "" : s.variables()));
            text.append(p.transitionOrder().isEmpty() ? "" : " order " + p.transitionOrder())
                    .append("\n");
        }
        for (Transition t : plan.transitions()) {
            text.append("  ").append(t.id()).append(" ").append(t.waitFor()).append(" ");
            t.inputs()
                    .forEach(i -> text.append(i.type())
                            .append(i.fields().isEmpty() ? " " : i.fields() + " ")
                            .append(i.writes().isEmpty() ? "" : "writes " + i.writes() + " "));
            for (InEdge e : plan.inEdgesOf(t.id())) {
                text.append(" ")
                        .append(e.place())
                        .append(e.requirements().stream().map(InWords::word).toList());
            }
            text.append(" ->");
            for (OutEdge e : plan.outEdgesOf(t.id())) {
                text.append(" ")
                        .append(e.place())
                        .append(e.requirements().stream().map(InWords::word).toList());
            }
            text.append("\n");
        }
        return text.toString();
    }

    private static String word(InRequirement r) {
        return r.kind() + r.task() + " " + r.match() + " " + r.n();
    }

    private static String word(OutRequirement r) {
        return r.action() + " " + (r.takesAll() ? "all" : r.n()) + " " + r.kind() + r.task();
    }
}
