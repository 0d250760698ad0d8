package org.sami.spn.reference;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.sami.spn.model.Action;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.model.WaitFor;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.testing.TestVocabulary;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.Reserved;

/** How often sessions exercised each rule of the language, as far as effects show it. */
final class Coverage {
    private static final List<EventRole> USED = List.of(
            EventRole.NONE,
            EventRole.TIMER_EXPIRED,
            EventRole.PROXY_TIMER_EXPIRED,
            EventRole.TOKENS_RETURNED,
            EventRole.INTERRUPT,
            EventRole.GENERAL_INTERRUPT_RECEIVED,
            EventRole.PROXY_INTERRUPT_RECEIVED,
            EventRole.ABORT_RECEIVED,
            EventRole.COMPLETE_RECEIVED,
            EventRole.SUB_MISSION_ABORTED,
            EventRole.CHECK_RETURN);
    private static final List<NoteKind> NOTES = List.of(
            NoteKind.DISCARDED,
            NoteKind.LATE,
            NoteKind.NAMES_NOBODY,
            NoteKind.GONE,
            NoteKind.SHORT_OF_TOKENS,
            NoteKind.NOT_RETURNED,
            NoteKind.INTERRUPT_REFUSED,
            NoteKind.LIVELOCK,
            NoteKind.REJECTED_INPUT,
            NoteKind.NO_AUTOMATIC_ANSWER);
    private static final List<String> LOADING = List.of(
            "project loaded",
            "equal project loaded",
            "project refused",
            "mission of a loaded project started",
            "sub-mission of an earlier project started",
            "firing of an earlier project",
            "global kept");
    /** What is asked of boats of which one is dropped then. */
    private static final List<String> QUESTIONS =
            List.of("Do", "Approve", "ApproveThem", "Choose", "ChooseSome", "Pick", "Provide");

    private static final String DROPPED = "boat dropped while asked: ";
    private static final List<String> OTHERS = List.of(
            "return checked of a named plan",
            "firing without event",
            "firing with several events",
            "firing that waited for all",
            "firing in a child",
            "firing in a grandchild",
            "firing out of a place with a dynamic sub-mission",
            "firing out of a place with a static sub-mission",
            "firing out of a place with several static sub-missions",
            "firing out of a place with its own order",
            "commands withdrawn from all",
            "commands withdrawn from some",
            "decision answered by OPERATOR",
            "decision answered by AUTONOMY",
            "decision closed without answer",
            "decision held",
            "task allocated",
            "task released",
            "task moved to another robot",
            "variable of a mission written",
            "global variable written",
            "dynamic sub-mission started",
            "static sub-mission started",
            "sub-mission with mapped tasks started",
            "sub-mission with mapped variables started",
            "entry by nobody activates",
            "visit ends");

    /** The rules that a count exercises; those of requirements are {@link #rulesOf} the words. */
    private static final Map<String, List<String>> RULES = Map.ofEntries(
            entry("event used TIMER_EXPIRED", "R-VIS-6"),
            entry("event used PROXY_TIMER_EXPIRED", "R-VIS-6"),
            entry("event used TOKENS_RETURNED", "R-ACT-5"),
            entry("event used INTERRUPT", "R-INT-1"),
            entry("event used GENERAL_INTERRUPT_RECEIVED", "R-INT-2"),
            entry("event used PROXY_INTERRUPT_RECEIVED", "R-INT-2"),
            entry("event used ABORT_RECEIVED", "R-END-1"),
            entry("event used COMPLETE_RECEIVED", "R-END-1"),
            entry("event used SUB_MISSION_ABORTED", "R-SUB-8"),
            entry("event used CHECK_RETURN", "R-RET-1"),
            entry("note SHORT_OF_TOKENS", "R-OUT-3"),
            entry("note GONE", "R-OCC-12"),
            entry("note LIVELOCK", "R-LOOK-9"),
            entry("note NO_AUTOMATIC_ANSWER", "R-DEC-2"),
            entry("mission ENDED", "R-END-3"),
            entry("mission ABORTED", "R-END-1"),
            entry("mission COMPLETED", "R-END-1"),
            entry("mission HALTED", "R-LOOK-9"),
            entry("return checked of a named plan", "R-RET-1"),
            entry("firing without event", "R-LOOK-1"),
            entry("firing with several events", "R-PEND-6"),
            entry("firing that waited for all", "R-PEND-7"),
            entry("firing in a child", "R-SUB-1"),
            entry("firing in a grandchild", "R-SUB-1"),
            entry("firing out of a place with a dynamic sub-mission", "R-SUB-3"),
            entry("firing out of a place with a static sub-mission", "R-SHR-4"),
            entry("firing out of a place with several static sub-missions", "R-SHR-9"),
            entry("firing out of a place with its own order", "R-LOOK-6"),
            entry("commands withdrawn from all", "R-END-4"),
            entry("commands withdrawn from some", "R-INT-6"),
            entry("decision answered by OPERATOR", "R-DEC-1"),
            entry("decision answered by AUTONOMY", "R-DEC-2"),
            entry("decision closed without answer", "R-DEC-3"),
            entry("decision held", "R-DEC-9"),
            entry("task allocated", "R-TASK-1"),
            entry("task released", "R-TASK-1"),
            entry("task moved to another robot", "R-TASK-1"),
            entry("variable of a mission written", "R-VAR-2"),
            entry("global variable written", "R-VAR-2"),
            entry("dynamic sub-mission started", "R-SUB-1"),
            entry("static sub-mission started", "R-SHR-1"),
            entry("sub-mission with mapped tasks started", "R-TASK-5"),
            entry("sub-mission with mapped variables started", "R-VAR-1"),
            entry("entry by nobody activates", "R-OUT-7"),
            entry("visit ends", "R-VIS-5"));

    private final Map<String, Long> counts = new LinkedHashMap<>();
    private final Map<String, Long> ofLoading = new LinkedHashMap<>();

    Coverage() {
        for (TokenKind kind : TokenKind.values()) {
            for (Match match : Match.values()) {
                boolean all = kind == TokenKind.RELEVANT || kind == TokenKind.UNCONDITIONAL;
                if (kind != TokenKind.SUB_MISSION_TOKENS
                        && (match == Match.ALL ? all : kind != TokenKind.UNCONDITIONAL)) {
                    counts.put(word(kind, match), 0L);
                }
            }
            for (Action action : Action.values()) {
                if (kind != TokenKind.UNCONDITIONAL || action == Action.ADD) {
                    counts.put(word(kind, action, true), 0L);
                }
                if (kind != TokenKind.UNCONDITIONAL) {
                    counts.put(word(kind, action, false), 0L);
                }
            }
        }
        USED.forEach(role -> counts.put("event used " + role, 0L));
        NOTES.forEach(kind -> counts.put("note " + kind, 0L));
        for (Outcome outcome : Outcome.values()) {
            counts.put("mission " + outcome, 0L);
        }
        OTHERS.forEach(rule -> counts.put(rule, 0L));
        QUESTIONS.forEach(type -> counts.put(DROPPED + type, 0L));
        LOADING.forEach(what -> ofLoading.put(what, 0L));
    }

    /** Counts what the effects of one input show; sessions on several threads count together. */
    synchronized void saw(Seen seen, List<Effect> effects) {
        for (Effect effect : effects) {
            loading(seen, effect);
            if (effect instanceof Effect.Fired f) {
                fired(seen, f);
            } else if (effect instanceof Effect.MissionStarted m && m.parent() != Ids.NONE) {
                started(seen.plans.get(m.parent()), m);
            } else if (effect instanceof Effect.VariableWritten w) {
                count(w.mission() == Ids.NONE ? "global variable written" : "variable of a mission written");
            } else if (effect instanceof Effect.TasksAllocated a) {
                a.robots()
                        .forEach((task, robot) -> count(
                                robot.isEmpty()
                                        ? "task released"
                                        : a.before().containsKey(task)
                                                ? "task moved to another robot"
                                                : "task allocated"));
            } else {
                sawSimple(effect);
            }
        }
    }

    /** A boat was dropped of which something was asked. */
    synchronized void droppedWhileAsked(String type) {
        if (QUESTIONS.contains(type)) {
            count(DROPPED + type);
        }
    }

    private void loading(Seen seen, Effect effect) {
        if (effect instanceof Effect.ProjectLoaded) {
            countLoading(seen.isFirstSight() ? "project loaded" : "equal project loaded");
        } else if (effect instanceof Effect.MissionStarted m && m.projectVersion() < seen.newest()) {
            countLoading("sub-mission of an earlier project started");
        } else if (effect instanceof Effect.MissionStarted m && m.projectVersion() > 1) {
            countLoading("mission of a loaded project started");
        } else if (effect instanceof Effect.Fired f && seen.versionOf(f.mission()) < seen.newest()) {
            countLoading("firing of an earlier project");
        } else if (effect instanceof Effect.Noted n && n.kind() == NoteKind.GLOBAL_KEPT) {
            countLoading("global kept");
        } else if (effect instanceof Effect.Noted n && n.message().equals(Loading.REFUSED)) {
            countLoading("project refused");
        }
    }

    private void countLoading(String what) {
        ofLoading.merge(what, 1L, Long::sum);
    }

    /** What was done with loaded projects less often. */
    List<String> ofLoading(long least) {
        return ofLoading.entrySet().stream()
                .filter(e -> e.getValue() < least)
                .map(e -> e.getKey() + ": " + e.getValue())
                .toList();
    }

    private void sawSimple(Effect effect) {
        if (effect instanceof Effect.Noted n) {
            count("note " + n.kind());
        } else if (effect instanceof Effect.MissionEnded m) {
            count("mission " + m.outcome());
        } else if (effect instanceof Effect.CommandsWithdrawn w) {
            count("commands withdrawn from " + (w.proxies().isEmpty() ? "all" : "some"));
        } else if (effect instanceof Effect.DecisionClosed d) {
            count(d.by().map(by -> "decision answered by " + by).orElse("decision closed without answer"));
        } else if (effect instanceof Effect.DecisionHeld) {
            count("decision held");
        } else if (effect instanceof Effect.Activated a
                && a.activation().tokens().isEmpty()) {
            count("entry by nobody activates");
        } else if (effect instanceof Effect.ActivationEnded) {
            count("visit ends");
        }
    }

    private void started(Plan parent, Effect.MissionStarted child) {
        parent.places().stream()
                .flatMap(p -> p.subMissions().stream())
                .filter(s -> s.plan().equals(child.plan()))
                .findFirst()
                .ifPresent(s -> {
                    count((s.shared() ? "static" : "dynamic") + " sub-mission started");
                    if (!s.tasks().isEmpty()) {
                        count("sub-mission with mapped tasks started");
                    }
                    if (!s.variables().isEmpty()) {
                        count("sub-mission with mapped variables started");
                    }
                });
    }

    private void fired(Seen seen, Effect.Fired f) {
        Plan plan = seen.plans.get(f.mission());
        Transition t = plan.transition(f.transition()).orElseThrow();
        for (InEdge edge : plan.inEdgesOf(t.id())) {
            for (InRequirement r : edge.requirements()) {
                count(word(r.kind(), r.match()));
            }
            plan.place(edge.place()).ifPresent(place -> {
                place.subMissions().stream()
                        .findFirst()
                        .ifPresent(s -> count("firing out of a place with a " + (s.shared() ? "static" : "dynamic")
                                + " sub-mission"));
                if (place.subMissions().stream().filter(s -> s.shared()).count() > 1) {
                    count("firing out of a place with several static sub-missions");
                }
                if (!place.transitionOrder().isEmpty()) {
                    count("firing out of a place with its own order");
                }
            });
        }
        for (OutEdge edge : plan.outEdgesOf(t.id())) {
            for (OutRequirement r : edge.requirements()) {
                count(word(r.kind(), r.action(), r.takesAll()));
            }
        }
        for (InputEventSpec event : t.inputs()) {
            count("event used "
                    + TestVocabulary.TEST.event(event.type()).orElseThrow().role());
            if (event.fields().containsKey(Reserved.SUB_MISSION)) {
                count("return checked of a named plan");
            }
        }
        firedBy(seen, f, t);
    }

    private void firedBy(Seen seen, Effect.Fired f, Transition t) {
        if (t.inputs().isEmpty()) {
            count("firing without event");
        } else if (t.inputs().size() > 1) {
            count("firing with several events");
        }
        if (t.waitFor() == WaitFor.ALL) {
            count("firing that waited for all");
        }
        if (!seen.isRoot(f.mission())) {
            count(seen.isRoot(seen.parents.get(f.mission())) ? "firing in a child" : "firing in a grandchild");
        }
    }

    private void count(String rule) {
        counts.merge(rule, 1L, Long::sum);
    }

    /** A table of the rules that were exercised less often than that; empty where none was. */
    List<String> below(long least) {
        return counts.entrySet().stream()
                .filter(e -> e.getValue() < least)
                .map(e -> "%6d  %s".formatted(e.getValue(), e.getKey()))
                .toList();
    }

    /** The rules of docs/semantics.md that sessions exercise where no count is {@link #below} the least. */
    Set<String> rules() {
        Set<String> rules = new TreeSet<>();
        counts.keySet().forEach(word -> rules.addAll(rulesOf(word)));
        return rules;
    }

    private static List<String> rulesOf(String word) {
        if (word.startsWith("in: ")) {
            return word.contains("unconditional") ? List.of("R-IN-4") : List.of("R-IN-1", "R-IN-2");
        }
        if (!word.startsWith("out: ")) {
            return RULES.getOrDefault(word, List.of());
        }
        if (word.endsWith("generic") && word.contains("add")) {
            return List.of("R-OUT-1", "R-OUT-4");
        } else if (word.endsWith("relevant")) {
            return List.of("R-OUT-1", "R-OUT-5");
        } else if (word.endsWith("sub mission tokens")) {
            return List.of("R-SUB-4");
        }
        return word.endsWith("unconditional") ? List.of("R-OUT-7") : List.of("R-OUT-1");
    }

    private static Map.Entry<String, List<String>> entry(String count, String... rules) {
        return Map.entry(count, List.of(rules));
    }

    private static String word(TokenKind kind, Match match) {
        return "in: " + word(kind) + " " + word(match);
    }

    private static String word(TokenKind kind, Action action, boolean all) {
        return "out: " + word(action) + (all ? " all " : " n ") + word(kind);
    }

    private static String word(Enum<?> constant) {
        return constant.name().toLowerCase(Locale.ROOT).replace('_', ' ');
    }
}
