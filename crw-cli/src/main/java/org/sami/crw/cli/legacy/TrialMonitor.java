package org.sami.crw.cli.legacy;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.MissionView;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.Severity;
import org.sami.spn.host.HostListener;
import org.sami.spn.host.HostStatus;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.Transition;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Token;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Vocabulary;

/** Watches a trial run and keeps what it shows of its plans: like things once, with how often they happened. */
final class TrialMonitor implements HostListener {
    private final Vocabulary vocabulary;
    private final Project project;
    private final Set<String> handled;
    private final Map<Long, String> planOfMission = new HashMap<>();
    private final Map<Long, String> askedBy = new HashMap<>();
    private String asked = ""; // what the present input answers, in words
    private final Map<String, Kept> kept = new LinkedHashMap<>();

    private static final class Kept {
        private final Severity severity;
        private final String code;
        private final String plan;
        private final String message;
        private int times;

        Kept(Severity severity, String code, String plan, String message) {
            this.severity = severity;
            this.code = code;
            this.plan = plan;
            this.message = message;
        }
    }

    /**
     * A watch over one run.
     *
     * @param handled the output events that have handlers
     */
    TrialMonitor(Vocabulary vocabulary, Project project, Set<String> handled) {
        this.vocabulary = vocabulary;
        this.project = project;
        this.handled = handled;
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        boolean isNews = input instanceof Input.Received received
                && received.occurrence().activation() == Ids.NONE;
        asked = input instanceof Input.Received answer
                ? askedBy.getOrDefault(answer.occurrence().activation(), "")
                : "";
        for (Effect effect : effects) {
            if (effect instanceof Effect.MissionStarted started) {
                planOfMission.put(started.mission(), started.plan());
            } else if (effect instanceof Effect.Activated activated) {
                activated(activated);
            } else if (effect instanceof Effect.Fired fired) {
                fired(fired);
            } else if (effect instanceof Effect.Noted noted && !(isNews && noted.kind() == NoteKind.DISCARDED)) {
                noted(noted);
            }
        }
    }

    @Override
    public void onFailed(HostStatus status) {
        keep(Severity.ERROR, TrialCodes.ENGINE, "", status.whole());
    }

    private void activated(Effect.Activated activated) {
        String type = activated.activation().type();
        String where =
                place(activated.activation().plan(), activated.activation().place());
        askedBy.put(activated.activation().id(), "; " + type + " in the place " + where + " had asked");
        boolean somebody = handled.contains(type)
                || vocabulary
                        .event(type)
                        .filter(e -> e.decision().isPresent() || e.role() != EventRole.NONE)
                        .isPresent();
        if (!somebody) {
            keep(
                    Severity.ERROR,
                    TrialCodes.UNHANDLED,
                    activated.activation().plan(),
                    "The place "
                            + place(
                                    activated.activation().plan(),
                                    activated.activation().place()) + " asks for "
                            + vocabulary.event(type).map(EventType::name).orElse(type) + ", which nothing handles");
        }
    }

    private void fired(Effect.Fired fired) {
        String plan = planOfMission.getOrDefault(fired.mission(), "");
        if (fired.moves().isEmpty() && !entersSomething(plan, fired.transition())) {
            keep(
                    Severity.WARNING,
                    TrialCodes.MOVES_NOTHING,
                    plan,
                    "The transition " + transition(plan, fired.transition()) + " fired and moved nothing");
        }
    }

    /** An unconditional edge is entered by nobody, an end place by every firing. */
    private boolean entersSomething(String planId, String transition) {
        return project.plan(planId).stream()
                .flatMap(plan -> plan.outEdgesOf(transition).stream()
                        .filter(edge -> edge.requirements().stream()
                                        .anyMatch(r -> r.kind() == org.sami.spn.model.TokenKind.UNCONDITIONAL)
                                || plan.place(edge.place()).map(Place::end).orElse(false)))
                .findAny()
                .isPresent();
    }

    private void noted(Effect.Noted noted) {
        String plan = planOfMission.getOrDefault(noted.mission(), "");
        switch (noted.kind()) {
            case DISCARDED -> keep(Severity.WARNING, TrialCodes.NOT_TAKEN, plan, noted.message() + asked);
            case LATE -> keep(Severity.NOTE, TrialCodes.LATE, plan, noted.message());
            case NAMES_NOBODY -> keep(Severity.WARNING, TrialCodes.NAMES_NOBODY, plan, noted.message());
            case SHORT_OF_TOKENS -> keep(Severity.WARNING, TrialCodes.SHORT_OF_TOKENS, plan, noted.message());
            case NOT_RETURNED -> keep(Severity.WARNING, TrialCodes.NOT_RETURNED, plan, noted.message());
            case INTERRUPT_REFUSED -> keep(Severity.NOTE, TrialCodes.INTERRUPT_REFUSED, plan, noted.message());
            case LIVELOCK -> keep(Severity.ERROR, TrialCodes.LIVELOCK, plan, noted.message());
            case HANDLER_FAILED -> {
                if (!noted.message().contains(": nothing handles ")) { // named when it was asked
                    keep(Severity.WARNING, TrialCodes.HANDLER_FAILED, plan, noted.message());
                }
            }
            case REJECTED_INPUT, NO_AUTOMATIC_ANSWER, GLOBAL_KEPT ->
                keep(Severity.WARNING, TrialCodes.REJECTED, plan, noted.message());
            case GONE -> {
                // the plan goes on without those who left: that is no defect of it
            }
        }
    }

    /** What the operator could not answer. */
    void unanswered(String plan, String trouble) {
        keep(Severity.WARNING, TrialCodes.UNANSWERED, plan, trouble);
    }

    /** Copies of one boat that stand in one place at the end. */
    void lookForCopies(EngineView view) {
        for (MissionView mission : view.missions()) {
            mission.marking().forEach((place, tokens) -> {
                Map<Token, Integer> counts = new LinkedHashMap<>();
                tokens.stream().filter(Token.Proxy.class::isInstance).forEach(t -> counts.merge(t, 1, Integer::sum));
                counts.forEach((token, count) -> {
                    if (count > 1) {
                        keep(
                                Severity.WARNING,
                                TrialCodes.COPIES,
                                mission.plan(),
                                "In the place " + place(mission.plan(), place) + " stand " + count + " copies of "
                                        + ((Token.Proxy) token).proxy());
                    }
                });
            });
        }
    }

    private void keep(Severity severity, String code, String plan, String message) {
        String alike =
                code + " " + plan + " " + message.replaceAll("\\d+", "#").replaceAll("boat#(, boat#| boat#)*", "boat");
        kept.computeIfAbsent(alike, key -> new Kept(severity, code, plan, message)).times++;
    }

    /** What was found, in the order in which it was first seen. */
    List<Finding> findings() {
        List<Finding> findings = new ArrayList<>();
        for (Kept one : kept.values()) {
            findings.add(new Finding(
                    one.severity,
                    one.code,
                    pointer(one.plan),
                    one.message + (one.times == 1 ? "" : " (" + one.times + " times)"),
                    one.plan.isEmpty() ? List.of() : List.of(one.plan)));
        }
        return findings;
    }

    private String pointer(String planId) {
        List<Plan> plans = project.plans();
        for (int i = 0; i < plans.size(); i++) {
            if (plans.get(i).id().equals(planId)) {
                return "/plans/" + i;
            }
        }
        return "";
    }

    private String place(String planId, String id) {
        return project.plan(planId)
                .flatMap(plan -> plan.place(id))
                .map(Place::name)
                .filter(name -> !name.isEmpty())
                .orElse(id);
    }

    private String transition(String planId, String id) {
        return project.plan(planId)
                .flatMap(plan -> plan.transition(id))
                .map(Transition::name)
                .filter(name -> !name.isEmpty())
                .orElse(id);
    }

    /** Ids of the plans that ran, the root's and those of its sub-missions. */
    Set<String> plansThatRan() {
        return new LinkedHashSet<>(planOfMission.values());
    }
}
