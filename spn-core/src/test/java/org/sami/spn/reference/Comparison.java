package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Priority;
import org.sami.spn.protocol.Question;

/** What must be equal after each input. */
final class Comparison {
    private static final Set<NoteKind> NOTES = EnumSet.of(
            NoteKind.LIVELOCK,
            NoteKind.NO_AUTOMATIC_ANSWER,
            NoteKind.HANDLER_FAILED,
            NoteKind.SHORT_OF_TOKENS,
            NoteKind.NOT_RETURNED,
            NoteKind.NAMES_NOBODY,
            NoteKind.GONE,
            NoteKind.INTERRUPT_REFUSED,
            NoteKind.LATE,
            NoteKind.DISCARDED);

    private static final String FROM_ALL = "withdrawn from all";

    private Comparison() {}

    /** What of one input's effects and of the states after it is not equal. */
    static Optional<String> difference(Subject interpreter, List<Effect> expected, Subject other, List<Effect> actual) {
        return Stream.of(
                        compare("projects loaded", loaded(expected), loaded(actual)),
                        compare("missions that began", begun(expected), begun(actual)),
                        compare("firings", firings(expected), firings(actual)),
                        compare("activations", activations(expected), activations(actual)),
                        compare("missions that ended", ended(expected), ended(actual)),
                        compare("commands sent and withdrawn", commands(expected), commands(actual)),
                        compare("tasks allocated", allocated(expected), allocated(actual)),
                        compare("markings", interpreter.markings(), other.markings()),
                        compare("visits by nobody", interpreter.visitedByNobody(), other.visitedByNobody()),
                        compare("statuses", interpreter.statuses(), other.statuses()),
                        compare("variables written", written(expected), written(actual)),
                        compare("decisions opened", opened(expected), opened(actual)),
                        compare("decisions closed", closed(expected), closed(actual)),
                        compare("decisions held", held(expected), held(actual)),
                        compare("notes", notes(expected), notes(actual)),
                        compare("open activations", interpreter.openActivations(), other.openActivations()),
                        compare("open decisions", interpreter.openDecisions(), other.openDecisions()),
                        compare("next due time", interpreter.nextDueMillis(), other.nextDueMillis()))
                .flatMap(Optional::stream)
                .reduce((a, b) -> a + "\n" + b);
    }

    private static Optional<String> compare(String what, Object expected, Object actual) {
        return expected.equals(actual)
                ? Optional.empty()
                : Optional.of("  " + what + "\n    interpreter: " + expected + "\n    other:       " + actual);
    }

    private static List<Effect> loaded(List<Effect> effects) {
        return effects.stream().filter(Effect.ProjectLoaded.class::isInstance).toList();
    }

    private static List<String> begun(List<Effect> effects) {
        List<String> found = new ArrayList<>();
        for (Effect effect : effects) {
            if (effect instanceof Effect.MissionStarted m) {
                found.add(m.mission() + " in '" + m.place() + "' of " + m.parent() + " runs " + m.plan()
                        + " of project " + m.projectVersion());
            }
        }
        return found;
    }

    private static List<String> firings(List<Effect> effects) {
        List<String> found = new ArrayList<>();
        for (Effect effect : effects) {
            if (effect instanceof Effect.Fired f) {
                found.add("#" + f.firing() + " mission " + f.mission() + " " + f.transition() + " with "
                        + f.used().stream().map(Comparison::word).toList());
            }
        }
        return found;
    }

    /** Without the activation: news to all can be an answer in one mission. */
    private static String word(Occurrence o) {
        return o.type() + o.proxies() + o.tasks() + o.values();
    }

    private static List<Activation> activations(List<Effect> effects) {
        List<Activation> found = new ArrayList<>();
        for (Effect effect : effects) {
            if (effect instanceof Effect.Activated a) {
                found.add(withoutPriority(a.activation()));
            }
        }
        return found;
    }

    private static Activation withoutPriority(Activation a) {
        return new Activation(
                a.id(),
                a.mission(),
                a.rootMission(),
                a.visit(),
                a.plan(),
                a.place(),
                a.event(),
                a.type(),
                a.values(),
                a.taskValues(),
                a.tokens(),
                a.allocation(),
                a.markups(),
                Priority.MEDIUM);
    }

    private static List<String> ended(List<Effect> effects) {
        List<String> found = new ArrayList<>();
        for (Effect effect : effects) {
            if (effect instanceof Effect.MissionEnded m) {
                found.add(m.mission() + " " + m.outcome());
            }
        }
        return found.stream().sorted().toList();
    }

    private static List<Map.Entry<String, Object>> written(List<Effect> effects) {
        List<Map.Entry<String, Object>> found = new ArrayList<>();
        for (Effect effect : effects) {
            if (effect instanceof Effect.VariableWritten w) {
                found.add(Map.entry(w.mission() + " " + w.variable(), w.value()));
            }
        }
        return found;
    }

    private static List<String> opened(List<Effect> effects) {
        List<String> found = new ArrayList<>();
        for (Effect effect : effects) {
            if (effect instanceof Effect.DecisionOpened d) {
                Decision decision = d.decision();
                found.add(decision.id() + " of mission " + decision.mission() + " for activation "
                        + decision.activation() + " "
                        + (decision.question() instanceof Question.FillIn ? "values" : decision.question())
                        + " until " + decision.deadlineMillis() + ", else "
                        + (decision.question() instanceof Question.FillIn ? "values" : decision.automatic()));
            }
        }
        return found;
    }

    /** By mission, for one mission's robots do not hear in which order others withdraw theirs. */
    private static Map<Long, List<String>> commands(List<Effect> effects) {
        Map<Long, List<String>> found = new TreeMap<>();
        for (Effect effect : effects) {
            if (effect instanceof Effect.CommandsWithdrawn w) {
                List<String> earlier = found.computeIfAbsent(w.mission(), key -> new ArrayList<>());
                if (w.proxies().isEmpty()) {
                    earlier.removeIf(word -> word.startsWith("withdrawn")); // all are more than some
                    earlier.add(FROM_ALL);
                } else if (!earlier.contains(FROM_ALL)) {
                    earlier.add(
                            "withdrawn from " + w.proxies().stream().sorted().toList());
                }
            } else if (effect instanceof Effect.Activated a) {
                found.computeIfAbsent(a.activation().mission(), key -> new ArrayList<>())
                        .add("activation " + a.activation().id());
            }
        }
        return found;
    }

    private static List<String> allocated(List<Effect> effects) {
        List<String> found = new ArrayList<>();
        for (Effect effect : effects) {
            if (effect instanceof Effect.TasksAllocated a) {
                found.add(a.robots() + " before " + a.before());
            }
        }
        return found;
    }

    private static List<Effect> held(List<Effect> effects) {
        return effects.stream().filter(Effect.DecisionHeld.class::isInstance).toList();
    }

    private static List<String> closed(List<Effect> effects) {
        List<String> found = new ArrayList<>();
        for (Effect effect : effects) {
            if (effect instanceof Effect.DecisionClosed d) {
                found.add(d.decision() + " with " + d.answer() + " by " + d.by());
            }
        }
        return found.stream().sorted().toList();
    }

    /**
     * Kinds and missions: each of the two has its own sentences. With a mission end its pending occurrences (R-END-5): which of
     * them were discarded on the way there is not compared.
     */
    private static List<String> notes(List<Effect> effects) {
        Set<Long> ended = new HashSet<>();
        List<String> found = new ArrayList<>();
        for (Effect effect : effects) {
            if (effect instanceof Effect.MissionEnded m) {
                ended.add(m.mission());
            }
        }
        for (Effect effect : effects) {
            if (effect instanceof Effect.Noted n && NOTES.contains(n.kind())) {
                boolean onTheWayToTheEnd = n.kind() == NoteKind.DISCARDED && ended.contains(n.mission());
                if (!onTheWayToTheEnd) {
                    found.add(n.kind() + " of mission " + n.mission());
                }
            }
        }
        return found.stream().sorted().toList();
    }
}
