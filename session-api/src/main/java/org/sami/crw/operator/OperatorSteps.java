package org.sami.crw.operator;

import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.sami.crw.operator.OperatorLogEntry.Kind;
import org.sami.crw.operator.mission.EngineText;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.NoteKind;

/** Logs what operators do through the engine, as far as the engine carried it out. For the owner's thread. */
final class OperatorSteps {
    private final OperatorLog log;
    private final Map<Long, Decision> open = new HashMap<>();

    OperatorSteps(OperatorLog log) {
        this.log = log;
    }

    /** No decision waits. */
    void clear() {
        open.clear();
    }

    /** These decisions wait. */
    void restore(List<Decision> decisions) {
        decisions.forEach(decision -> open.put(decision.id(), decision));
    }

    /**
     * One step of the engine.
     *
     * @param isNew whether it happens now, rather than being heard of again
     */
    void apply(Input input, List<Effect> effects, boolean isNew) {
        if (isNew && !wasRefused(effects)) {
            log(input, effects);
        }
        for (Effect effect : effects) {
            if (effect instanceof Effect.DecisionOpened opened) {
                open.put(opened.decision().id(), opened.decision());
            } else if (effect instanceof Effect.DecisionClosed closed) {
                open.remove(closed.decision());
            }
        }
    }

    private static boolean wasRefused(List<Effect> effects) {
        return effects.stream()
                .anyMatch(effect -> effect instanceof Effect.Noted noted
                        && (noted.kind() == NoteKind.REJECTED_INPUT || noted.kind() == NoteKind.INTERRUPT_REFUSED));
    }

    private void log(Input input, List<Effect> effects) {
        if (input instanceof Input.StartMission start) {
            long mission = started(effects);
            log.add(Kind.MISSION, "started " + start.plan() + " as mission " + mission, mission, List.of());
        } else if (input instanceof Input.AbortMission abort) {
            log.add(Kind.MISSION, "aborted " + missions(abort.mission()), abort.mission(), List.of());
        } else if (input instanceof Input.CompleteMission complete) {
            log.add(Kind.MISSION, "completed " + missions(complete.mission()), complete.mission(), List.of());
        } else if (input instanceof Input.ProxyDropped dropped) {
            String from = missions(dropped.mission());
            log.add(
                    Kind.MISSION,
                    "dropped " + dropped.proxy() + " from " + from,
                    dropped.mission(),
                    List.of(dropped.proxy()));
        } else if (input instanceof Input.Interrupt press) {
            String whom = press.proxies().isEmpty() ? "" : " for " + String.join(", ", press.proxies());
            log.add(
                    Kind.INTERRUPT,
                    "pressed " + press.name() + whom + " in " + missions(press.mission()),
                    press.mission(),
                    press.proxies());
        } else if (input instanceof Input.SetVariable set) {
            log.add(
                    Kind.PROJECT,
                    "set " + set.variable() + " = " + EngineText.value(set.value()),
                    set.mission(),
                    List.of());
        } else if (input instanceof Input.LoadProject) {
            log.add(Kind.PROJECT, "loaded a project");
        } else if (input instanceof Input.AnswerDecision answer && answer.by() == Answerer.OPERATOR) {
            answered(answer, effects);
        } else if (input instanceof Input.HoldDecision hold && open.containsKey(hold.decision())) {
            Decision held = open.get(hold.decision());
            log.add(Kind.ANSWER, "held [" + held.id() + "] " + asked(held), held.mission(), List.of());
        }
    }

    private static String asked(Decision decision) {
        return decision.prompt().isEmpty() ? decision.type() : decision.prompt();
    }

    private void answered(Input.AnswerDecision answer, List<Effect> effects) {
        Decision decision = open.get(answer.decision());
        boolean closed = effects.stream()
                .anyMatch(
                        effect -> effect instanceof Effect.DecisionClosed done && done.decision() == answer.decision());
        if (decision != null && closed) {
            log.add(
                    Kind.ANSWER,
                    String.format(
                            Locale.ROOT,
                            "answered [%d] %s: %s",
                            decision.id(),
                            asked(decision),
                            EngineText.answer(answer.answer())),
                    decision.mission(),
                    List.of());
        }
    }

    private static long started(List<Effect> effects) {
        return effects.stream()
                .filter(effect -> effect instanceof Effect.MissionStarted started && started.parent() == Ids.NONE)
                .mapToLong(effect -> ((Effect.MissionStarted) effect).mission())
                .findFirst()
                .orElse(Ids.NONE);
    }

    private static String missions(long mission) {
        return mission == Ids.NONE ? "all missions" : "mission " + mission;
    }
}
