package org.sami.spn.protocol;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Collections;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

/**
 * Something from outside that the engine reacts to. Each is journalled with the time at which the host took it in.
 * Inputs that make no sense (an unknown plan, a decision that was answered before) change nothing and are noted.
 *
 * <p>Implements R-TOK-4.
 */
public sealed interface Input {

    /**
     * Starts a root mission.
     *
     * @param parameters values for asked fields, by {@code eventId.field} or by the field's name where that is unique in the
     *     plan, and for variables by {@code @name}; what is asked and not given here becomes a decision
     */
    record StartMission(String plan, String name, Map<String, Value> parameters) implements Input {
        public StartMission {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(name, "name");
            parameters = Collections.unmodifiableMap(new LinkedHashMap<>(parameters));
        }
    }

    /**
     * Loads a project while missions run: those keep the plans with which they started, missions that start later take
     * the loaded ones (docs/decisions 0176). Whoever posts it has checked the project's plans.
     *
     * @param document the project as {@code ProjectWriter} writes it, in the words of the session's vocabulary
     */
    record LoadProject(String document) implements Input {
        public LoadProject {
            Objects.requireNonNull(document, "document");
        }

        /** The SHA-256 of the document's UTF-8, in 64 hexadecimal digits: by it journals and states name the project. */
        public String sha256() {
            try {
                byte[] digest = MessageDigest.getInstance("SHA-256").digest(document.getBytes(StandardCharsets.UTF_8));
                return HexFormat.of().formatHex(digest);
            } catch (NoSuchAlgorithmException missing) {
                throw new IllegalStateException("every Java platform has SHA-256", missing);
            }
        }
    }

    /** An input event arrives. */
    record Received(Occurrence occurrence) implements Input {
        public Received {
            Objects.requireNonNull(occurrence, "occurrence");
        }
    }

    /** A robot becomes known; running missions do not change. */
    record ProxyJoined(String proxy) implements Input {
        public ProxyJoined {
            Objects.requireNonNull(proxy, "proxy");
        }
    }

    /**
     * The operator drops a robot: its tokens go, nobody waits for it any longer.
     *
     * @param mission the root mission, or {@link Ids#NONE} for all, which also makes it unknown
     */
    record ProxyDropped(String proxy, long mission) implements Input {
        public ProxyDropped {
            Objects.requireNonNull(proxy, "proxy");
        }
    }

    /** Nothing but the passing of time: timers and deadlines that are due run down. Every input does that first. */
    record TimeReached() implements Input {}

    /**
     * A button is pressed.
     *
     * @param mission the mission that offers it, or {@link Ids#NONE} for every running mission that does
     * @param proxies the robots concerned; empty for a general one, or where they will be chosen
     */
    record Interrupt(long mission, String name, List<String> proxies) implements Input {
        public Interrupt {
            Objects.requireNonNull(name, "name");
            proxies = List.copyOf(proxies);
        }
    }

    /** Aborts a mission, or all running ones with {@link Ids#NONE}. */
    record AbortMission(long mission) implements Input {}

    /** Completes a mission. */
    record CompleteMission(long mission) implements Input {}

    /** Answers a decision. The first answer counts. */
    record AnswerDecision(long decision, Answer answer, Answerer by) implements Input {
        public AnswerDecision {
            Objects.requireNonNull(answer, "answer");
            Objects.requireNonNull(by, "by");
        }
    }

    /**
     * The operator decides alone: the timer of a decision that autonomy would answer is stopped, and autonomy does not answer it any
     * longer.
     */
    record HoldDecision(long decision) implements Input {}

    /** Writes a variable as a write of that mission would; {@link Ids#NONE} writes a global one. */
    record SetVariable(long mission, String variable, Value value) implements Input {
        public SetVariable {
            Objects.requireNonNull(variable, "variable");
            Objects.requireNonNull(value, "value");
        }
    }

    /** Allocates tasks to robots, or releases them (empty). */
    record AllocateTasks(Map<TaskId, Optional<String>> allocation) implements Input {
        public AllocateTasks {
            allocation = Collections.unmodifiableMap(new LinkedHashMap<>(allocation));
        }
    }

    /** Adds tasks to a running mission; their tokens enter only by an occurrence that names them. */
    record AddTasks(long mission, List<TaskSpec> tasks) implements Input {
        public AddTasks {
            tasks = List.copyOf(tasks);
        }
    }

    /**
     * The domain asks the operator for a yes or a no, or which robots are chosen, outside of any plan; autonomy answers only where it is told what and when. Asked
     * again while it is open, it changes nothing.
     *
     * @param kind names what is asked, such as {@code BoatRestarted}; becomes the decision's type
     * @param about its subject; there is one open question of a kind for each subject
     * @param prompt one sentence for the operator
     * @param proxies robots of which any number, also none, can be chosen; empty for a yes or a no
     * @param unanswered what autonomy answers to a question for a yes or a no that nobody has answered in time; empty where it waits without end
     */
    record AskOperator(
            String kind,
            String about,
            String prompt,
            Priority priority,
            List<String> proxies,
            Optional<Unanswered> unanswered)
            implements Input {
        /**
         * An answer in place of the operator's.
         *
         * @param afterMillis so long after it was asked, 0 or more
         */
        public record Unanswered(boolean yes, long afterMillis) {
            public Unanswered {
                if (afterMillis < 0) {
                    throw new IllegalArgumentException(
                            "autonomy answers after the question, not " + afterMillis + " ms");
                }
            }
        }

        /** A question for a yes or a no, which waits without end. */
        public AskOperator(String kind, String about, String prompt, Priority priority) {
            this(kind, about, prompt, priority, List.of(), Optional.empty());
        }

        /** A question that waits without end. */
        public AskOperator(String kind, String about, String prompt, Priority priority, List<String> proxies) {
            this(kind, about, prompt, priority, proxies, Optional.empty());
        }

        public AskOperator {
            Objects.requireNonNull(kind, "kind");
            Objects.requireNonNull(about, "about");
            Objects.requireNonNull(prompt, "prompt");
            Objects.requireNonNull(priority, "priority");
            proxies = List.copyOf(proxies);
            Objects.requireNonNull(unanswered, "unanswered");
            if (unanswered.isPresent() && !proxies.isEmpty()) {
                throw new IllegalArgumentException("autonomy answers yes or no, and chooses no robots: " + prompt);
            }
        }
    }

    /** The domain needs no answer any longer; a question that is not open changes nothing. */
    record WithdrawQuestion(String kind, String about) implements Input {
        public WithdrawQuestion {
            Objects.requireNonNull(kind, "kind");
            Objects.requireNonNull(about, "about");
        }
    }

    /** A handler could not do what an activation asked. The question stays open; the failure is noted. */
    record HandlerFailed(long activation, String reason) implements Input {
        public HandlerFailed {
            Objects.requireNonNull(reason, "reason");
        }
    }

    /**
     * Handlers' own memory of a mission, such as progress along a path, kept until the mission ends; with {@link Ids#NONE} that
     * of the session, such as which start of a robot's server was met last.
     */
    record Remember(long mission, String key, Value value) implements Input {
        public Remember {
            Objects.requireNonNull(key, "key");
            Objects.requireNonNull(value, "value");
        }
    }
}
