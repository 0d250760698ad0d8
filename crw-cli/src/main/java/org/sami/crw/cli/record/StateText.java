package org.sami.crw.cli.record;

import java.io.PrintWriter;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import org.sami.spn.engine.EnablingExplanation;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.InterruptButton;
import org.sami.spn.engine.MissionView;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Token;

/** The state of an engine in words: what stands where, what is asked, and why nothing fires. */
final class StateText {
    private final EngineView view;

    StateText(EngineView view) {
        this.view = view;
    }

    void print(PrintWriter out) {
        if (view.projectVersion() > 1) {
            out.printf(
                    "project %d is loaded: %s%n",
                    view.projectVersion(), view.project().id());
        }
        out.println("robots: " + (view.proxies().isEmpty() ? "none" : String.join(", ", view.proxies())));
        List<MissionView> missions = view.missions();
        if (missions.isEmpty()) {
            out.println("no mission runs");
        }
        missions.forEach(mission -> print(out, mission));
        for (Decision decision : view.decisions()) {
            out.printf("decision %d of mission %d: %s%n", decision.id(), decision.mission(), decision.prompt());
        }
        for (InterruptButton button : view.interrupts()) {
            out.printf("interrupt of mission %d: %s%n", button.mission(), button.name());
        }
        view.nextDueMillis().ifPresent(due -> out.println("next timer due at " + time(due)));
    }

    private void print(PrintWriter out, MissionView mission) {
        out.printf(
                "%nmission %d%s: %s (plan %s%s), %s%n",
                mission.id(),
                mission.parent() == Ids.NONE ? "" : " of mission " + mission.parent(),
                mission.name(),
                mission.plan(),
                view.projectVersion() > 1 ? " of project " + mission.projectVersion() : "",
                mission.status().name().toLowerCase(Locale.ROOT));
        view.planOf(mission.id()).ifPresent(plan -> {
            mission.marking()
                    .forEach((place, tokens) -> out.printf("  %s: %s%n", placeName(plan, place), words(tokens)));
            Set<String> marked = mission.marking().keySet();
            Set<String> near = plan.inEdges().stream()
                    .filter(edge -> marked.contains(edge.place()))
                    .map(InEdge::transition)
                    .collect(Collectors.toSet());
            plan.transitions().stream().filter(t -> near.contains(t.id())).forEach(t -> explain(out, mission, t));
        });
    }

    private void explain(PrintWriter out, MissionView mission, Transition transition) {
        EnablingExplanation why = view.whyNotEnabled(mission.id(), transition.id());
        String name = transition.name().isEmpty() ? transition.id() : transition.name();
        out.printf("    '%s' %s%n", name, why.yes() ? "can fire" : "cannot fire:");
        why.reasons().forEach(reason -> out.println("      " + reason));
    }

    private static String placeName(Plan plan, String id) {
        return plan.place(id).map(Place::name).filter(name -> !name.isEmpty()).orElse(id);
    }

    private static String words(List<Token> tokens) {
        return tokens.stream().map(StateText::word).collect(Collectors.joining(", "));
    }

    private static String word(Token token) {
        if (token instanceof Token.Proxy proxy) {
            return proxy.proxy();
        }
        return token instanceof Token.Task task ? "task " + task.task().name() : "a generic token";
    }

    static String time(long millis) {
        return String.format(Locale.ROOT, "%.1f s", millis / 1000.0);
    }
}
