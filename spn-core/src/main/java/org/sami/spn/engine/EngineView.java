package org.sami.spn.engine;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Questions about the state of an engine. Valid only on the thread that owns the state and until its next step; what the
 * answers contain is immutable and may be kept.
 */
public interface EngineView {
    /** Missions and instances that have not ended, in order of creation; halted ones included. */
    List<MissionView> missions();

    /** One mission that has not ended. */
    Optional<MissionView> mission(long id);

    /**
     * What stands where, as the effects that would tell it to somebody who heard none before: each mission's start, then its
     * visits with what is left of them. A {@code FollowedMarking} that begins in the middle of a session starts with them.
     */
    List<Effect> markingAsEffects();

    /** A plan of the newest project, by its id: what a mission would have that starts now. */
    Optional<Plan> plan(String id);

    /** The newest project: the last that was loaded, else the one with which the session began. */
    Project project();

    /** The session's number for the newest project; 1 where none was loaded. */
    int projectVersion();

    /** The plan of a mission that has not ended, of the project with which its root mission started. */
    Optional<Plan> planOf(long mission);

    /** The globals of the newest project that have a value, in the project's order. */
    Map<String, Value> globals();

    /** The words of the session's plans. */
    Vocabulary vocabulary();

    /** Open decisions, in order of creation. */
    List<Decision> decisions();

    /** What an open question of the domain is about, as {@code Input.AskOperator} named it; empty for any other decision. */
    Optional<String> subject(long decision);

    /** Interrupts that can be pressed now, in order of missions and plans. */
    List<InterruptButton> interrupts();

    /** Known robots in the order in which they joined. */
    List<String> proxies();

    /** A variable as that mission reads it; {@code Ids.NONE} reads global ones only. */
    Optional<Value> variable(long mission, String name);

    /** What was answered, or given, for a field that is asked when a mission starts; its key is {@code eventId.field}. */
    Optional<Value> parameter(long mission, String key);

    /** Tasks of running missions that are allocated, with their robots. */
    Map<TaskId, String> allocation();

    /**
     * A task by the names that running missions have for it: of its owner first, then of the sub-missions in which another name stands
     * for it. Empty where there is no such task.
     */
    List<TaskId> namesOf(TaskId task);

    /** The fields of a task of a running mission. */
    Optional<Map<String, Value>> task(TaskId task);

    /** Whether some attentive transition waits for an input event of this type now (docs/writing-a-domain.md). */
    boolean awaits(String inputEvent);

    /** What handlers remembered for a mission, or with {@code Ids.NONE} for the session ({@code Input.Remember}). */
    Optional<Value> memory(long mission, String key);

    /** The activation of an id, if its visit has not ended. */
    Optional<Activation> activation(long id);

    /** Activations whose visits have not ended, in order of id. */
    List<Activation> openActivations();

    /** What the transitions of a running mission have received and keep, by transition, in order of arrival. */
    List<PendingAnswer> pendingAnswers(long mission);

    /** When the next timer or deadline is due, in milliseconds on the session's clock. */
    OptionalLong nextDueMillis();

    /** When timers and deadlines are due, in milliseconds on the session's clock: each such time once, in order. */
    List<Long> dueMillis();

    /** Why a transition of a running mission cannot fire now, in words. */
    EnablingExplanation whyNotEnabled(long mission, String transition);
}
