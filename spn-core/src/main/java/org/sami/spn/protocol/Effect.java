package org.sami.spn.protocol;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

/** Something that the engine did or asks for, in the order in which it happened. */
public sealed interface Effect {

    /** A mission or sub-mission instance began; parent is {@link Ids#NONE} for a root. */
    record MissionStarted(long mission, long parent, String plan, String name) implements Effect {}

    /**
     * A transition fired.
     *
     * @param firing number of the firing in the session, from 1
     * @param used the occurrences that it used up
     * @param moves what happened to tokens, in order
     */
    record Fired(long firing, long mission, String transition, List<Occurrence> used, List<TokenMove> moves)
            implements Effect {
        public Fired {
            Objects.requireNonNull(transition, "transition");
            used = List.copyOf(used);
            moves = List.copyOf(moves);
        }
    }

    /** An output event asks its handler for something. */
    record Activated(Activation activation) implements Effect {}

    /** The visit of an activation ended: later answers to it will be discarded. Commands already sent go on. */
    record ActivationEnded(long activation) implements Effect {}

    /** The operator is asked. */
    record DecisionOpened(Decision decision) implements Effect {}

    /** A question is no longer open; without an answer, its visit or mission ended. */
    record DecisionClosed(long decision, Optional<Answer> answer, Optional<Answerer> by) implements Effect {}

    /** The operator has answered what the domain asked ({@link Input.AskOperator}). */
    record QuestionAnswered(String kind, String about, boolean yes) implements Effect {
        public QuestionAnswered {
            Objects.requireNonNull(kind, "kind");
            Objects.requireNonNull(about, "about");
        }
    }

    /**
     * What was commanded for a mission is withdrawn from its robots.
     *
     * @param proxies the robots concerned; empty = all
     */
    record CommandsWithdrawn(long mission, List<String> proxies) implements Effect {
        public CommandsWithdrawn {
            proxies = List.copyOf(proxies);
        }
    }

    /**
     * Tasks were allocated to robots or released, by one allocation; also where it changes no robot, as it says in which order they
     * are to be done.
     *
     * @param robots the robot of each task, in the order of the allocation; empty = released. Tasks by the names of the missions
     *     that own them
     * @param before the robots of those that had one
     * @param priority how urgent the allocation is
     */
    record TasksAllocated(Map<TaskId, Optional<String>> robots, Map<TaskId, String> before, Priority priority)
            implements Effect {
        public TasksAllocated {
            robots = Collections.unmodifiableMap(new LinkedHashMap<>(robots));
            before = Collections.unmodifiableMap(new LinkedHashMap<>(before));
            Objects.requireNonNull(priority, "priority");
        }
    }

    /** A variable received a value; mission is {@link Ids#NONE} for a global one, else the mission that owns it. */
    record VariableWritten(long mission, String variable, Value value) implements Effect {}

    /** Something worth telling; message is one sentence. */
    record Noted(NoteKind kind, long mission, String message) implements Effect {
        public Noted {
            Objects.requireNonNull(kind, "kind");
            Objects.requireNonNull(message, "message");
        }
    }

    /** A mission or instance is over; it never reacts again. */
    record MissionEnded(long mission, Outcome outcome) implements Effect {}
}
