package org.sami.spn.protocol;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.model.Project;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

/** Something that the engine did or asks for, in the order in which it happened. */
public sealed interface Effect {

    /**
     * A mission or sub-mission instance began.
     *
     * @param parent the mission that it is an instance for; {@link Ids#NONE} for a root
     * @param place the parent's place that runs it; empty text for a root
     * @param projectVersion of which of the session's projects the plan is ({@link ProjectLoaded}); 1 where none was loaded
     */
    record MissionStarted(long mission, long parent, String place, String plan, String name, int projectVersion)
            implements Effect {
        public MissionStarted {
            Objects.requireNonNull(place, "place");
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(name, "name");
        }

        /** A mission of the project with which the session began. */
        public MissionStarted(long mission, long parent, String place, String plan, String name) {
            this(mission, parent, place, plan, name, 1);
        }
    }

    /**
     * Missions that start from now on have the plans of this project ({@link Input.LoadProject}).
     *
     * @param version the session's number for it: the project with which it began is 1, each that differs from the one before is
     *     one more; a project equal to the newest changes nothing and is reported with that number
     */
    record ProjectLoaded(int version, Project project) implements Effect {
        public ProjectLoaded {
            Objects.requireNonNull(project, "project");
        }
    }

    /**
     * Tokens, or nobody, entered a place: a visit began. Told for each visit, whatever began it: the start marking, a firing,
     * tokens that join a static sub-mission. Together with {@link Left}, {@link MissionStarted} and {@link MissionEnded} it says
     * all that changes a marking ({@link FollowedMarking}).
     *
     * @param tokens in order of entry; empty where nobody entered
     */
    record Entered(long mission, String place, long visit, List<Token> tokens) implements Effect {
        public Entered {
            Objects.requireNonNull(place, "place");
            tokens = List.copyOf(tokens);
        }
    }

    /**
     * Tokens left a place, or a visit by nobody ended. Told whatever took them: a firing, a dropped robot, an interrupt in a
     * parent, the return from a static sub-mission. Not emitted where the mission ends, because then nothing stands in it any longer.
     *
     * @param visit the visit by which they had entered; of equal tokens of one visit the oldest leaves
     * @param tokens in the order in which they leave; empty where nobody had entered
     */
    record Left(long mission, String place, long visit, List<Token> tokens) implements Effect {
        public Left {
            Objects.requireNonNull(place, "place");
            tokens = List.copyOf(tokens);
        }
    }

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

    /** The timer of a decision was stopped: autonomy will not answer it ({@link Input.HoldDecision}). */
    record DecisionHeld(long decision) implements Effect {}

    /**
     * The operator has answered what the domain asked ({@link Input.AskOperator}).
     *
     * @param yes the answer; where robots were to be chosen, whether any was
     * @param proxies the robots that the operator chose, where that was asked
     */
    record QuestionAnswered(String kind, String about, boolean yes, List<String> proxies) implements Effect {
        /** The answer to a question for a yes or a no. */
        public QuestionAnswered(String kind, String about, boolean yes) {
            this(kind, about, yes, List.of());
        }

        public QuestionAnswered {
            proxies = List.copyOf(proxies);
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

    /**
     * A mission or instance is over; it never reacts again. Nothing stands in it any longer, unless it was halted: then its
     * marking stays, and a second effect reports that it was aborted.
     */
    record MissionEnded(long mission, Outcome outcome) implements Effect {}
}
