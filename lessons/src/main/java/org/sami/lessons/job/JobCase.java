package org.sami.lessons.job;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.OptionalLong;

/**
 * A hidden case: a run on the engine with scripted operator, robots and services.
 *
 * @param robots those known at the start, in order
 * @param locations how many the operator and services give where nothing else is said
 * @param script where it goes otherwise than well
 * @param watch the types of output events that are compared; all where there is none
 * @param expect words for what differs, the first that does not hold is said
 */
public record JobCase(
        String name,
        List<String> robots,
        int locations,
        List<Reaction> script,
        List<Happening> happenings,
        List<String> watch,
        List<Expect> expect) {
    public JobCase {
        Objects.requireNonNull(name, "name");
        robots = List.copyOf(robots);
        script = List.copyOf(script);
        happenings = List.copyOf(happenings);
        watch = List.copyOf(watch);
        expect = List.copyOf(expect);
    }

    /** Who acts in the case, as the beginning of a sentence: "With 3 robots". */
    public String words() {
        String who = switch (robots.size()) {
            case 0 -> "With no robot";
            case 1 -> "With one robot";
            default -> "With " + robots.size() + " robots";
        };
        return script.isEmpty() && happenings.isEmpty() ? who : who + " (" + name + ")";
    }

    /**
     * How a question of an output event is answered.
     *
     * @param on type of the output event
     * @param robots of whom it is asked; of anybody where there is none
     * @param tasks about which tasks, by the order of their making from 1; about any where there is none
     * @param time the how-manieth such question from 1; every one where it is empty
     * @param afterMillis how long the answer takes
     * @param isSilent whether it is never answered
     * @param answer type of the answering input event; the one that says that all goes well where it is empty text
     * @param values fields of the answer, as in a plan file
     * @param choose names of the chosen robots, or the how-manieth option
     */
    public record Reaction(
            String on,
            List<String> robots,
            List<Integer> tasks,
            OptionalInt time,
            OptionalLong afterMillis,
            boolean isSilent,
            String answer,
            Map<String, JsonNode> values,
            Optional<Choice> choose) {
        public Reaction {
            Objects.requireNonNull(on, "on");
            robots = List.copyOf(robots);
            tasks = List.copyOf(tasks);
            Objects.requireNonNull(time, "time");
            Objects.requireNonNull(afterMillis, "afterMillis");
            Objects.requireNonNull(answer, "answer");
            values = Collections.unmodifiableMap(new LinkedHashMap<>(values));
            Objects.requireNonNull(choose, "choose");
        }
    }

    /** What an operator chooses: robots by their names, or an option by its number from 1. */
    public record Choice(List<String> robots, int option) {
        public Choice {
            robots = List.copyOf(robots);
        }
    }

    /** Something that happens by itself. */
    public record Happening(long atMillis, What what) {
        public Happening {
            Objects.requireNonNull(what, "what");
        }
    }

    /** What can happen by itself. */
    public sealed interface What {
        /** An input event arrives: news, or the answer to what was asked of a robot and is still open. */
        record News(String type, List<String> robots, List<Integer> tasks, Map<String, JsonNode> values)
                implements What {
            public News {
                Objects.requireNonNull(type, "type");
                robots = List.copyOf(robots);
                tasks = List.copyOf(tasks);
                values = Collections.unmodifiableMap(new LinkedHashMap<>(values));
            }
        }

        /** The operator presses an interrupt. */
        record Press(String interrupt, List<String> robots) implements What {
            public Press {
                Objects.requireNonNull(interrupt, "interrupt");
                robots = List.copyOf(robots);
            }
        }

        /** The operator drops a robot. */
        record Drop(String robot) implements What {
            public Drop {
                Objects.requireNonNull(robot, "robot");
            }
        }

        /** A robot becomes known. */
        record Join(String robot) implements What {
            public Join {
                Objects.requireNonNull(robot, "robot");
            }
        }
    }

    /** Words for a difference. */
    public record Expect(Wanted wanted, String otherwise) {
        public Expect {
            Objects.requireNonNull(wanted, "wanted");
            Objects.requireNonNull(otherwise, "otherwise");
        }
    }

    /** What is expected of a run. */
    public sealed interface Wanted {
        /** Whether it holds. */
        boolean holds(CaseRun run);

        /** The mission ends, or does not. */
        record Ends(boolean ends) implements Wanted {
            @Override
            public boolean holds(CaseRun run) {
                return ends == (run.end() == CaseRun.End.ENDED);
            }
        }

        /**
         * An output event happens so often: to each robot or task counted, maybe to one robot only.
         *
         * @param times empty: at least once
         */
        record Happens(String event, List<String> robots, OptionalInt times) implements Wanted {
            public Happens {
                Objects.requireNonNull(event, "event");
                robots = List.copyOf(robots);
                Objects.requireNonNull(times, "times");
            }

            @Override
            public boolean holds(CaseRun run) {
                long count = run.trace().stream()
                        .filter(item ->
                                item.type().equals(event) && item.robots().containsAll(robots))
                        .count();
                return times.isPresent() ? count == times.getAsInt() : count > 0;
            }
        }

        /** An output event happens only when the last input event of a type has been received. */
        record AfterAll(String event, String answers) implements Wanted {
            public AfterAll {
                Objects.requireNonNull(event, "event");
                Objects.requireNonNull(answers, "answers");
            }

            @Override
            public boolean holds(CaseRun run) {
                return run.firstOf(event).isEmpty()
                        || run.lastAnswer(answers).isEmpty()
                        || run.firstOf(event).getAsLong()
                                >= run.lastAnswer(answers).getAsLong();
            }
        }
    }
}
