package org.sami.spn.vocabulary;

/**
 * Names of markups, their options and fields that the engine itself reads or fills; a vocabulary that wants the engine's
 * behaviour uses them.
 */
public final class Reserved {
    /** The reserved variable that reads a field from each entering task (thesis 9.3.4). */
    public static final String TASK_VARIABLE = "@task";

    /** Field of a check of return values: the plan whose sub-mission must have returned; may be missing (appendix .2.2). */
    public static final String SUB_MISSION = "subMission";

    /** Markup: whether and when autonomy answers a decision (thesis 3.1, Markup; appendix .2.3). */
    public static final String MIXED_INITIATIVE_TRIGGER = "MixedInitiativeTrigger";

    /** Option of {@link #MIXED_INITIATIVE_TRIGGER}: one of the three constants below. */
    public static final String TRIGGER = "trigger";

    /** Constant of {@link #TRIGGER}: the operator alone answers, as without the markup. */
    public static final String NEVER = "NEVER";

    /** Constant of {@link #TRIGGER}: autonomy answers in the same step. */
    public static final String IMMEDIATELY = "IMMEDIATELY";

    /** Constant of {@link #TRIGGER}: autonomy answers when {@link #TIMEOUT} has passed. */
    public static final String TIMER = "TIMER";

    /** Option of {@link #MIXED_INITIATIVE_TRIGGER}: a duration, for {@link #TIMER}. */
    public static final String TIMEOUT = "timeout";

    /** Markup: rank of an interaction or a command. */
    public static final String PRIORITY = "Priority";

    /** Option of {@link #PRIORITY}: a constant of {@code org.sami.spn.protocol.Priority}. */
    public static final String RANK = "rank";

    /** Markup: which options a decision offers (thesis 6.3.2). */
    public static final String FILTER = "Filter";

    /** Option of {@link #FILTER}: the text that an option contains. */
    public static final String SOURCE = "source";

    /** Option of {@link #FILTER}: the constant {@link #EXCLUDE}, or another one for keeping what contains the text. */
    public static final String ACTION = "action";

    /** Constant of {@link #ACTION}: what contains the text is left out. */
    public static final String EXCLUDE = "EXCLUDE";

    /** Markup: what is selected when a decision opens. */
    public static final String DEFAULT_SELECTION = "DefaultSelection";

    /** Option of {@link #DEFAULT_SELECTION}: the constant {@link #NONE}, or another one for all. */
    public static final String SELECTION = "selection";

    /** Constant of {@link #SELECTION}: nothing is selected. */
    public static final String NONE = "NONE";

    /** Prefix of the key under which the session remembers a robot's other name, as a text; its id follows. */
    public static final String DESCRIPTION_KEY = "description/";

    /** Markup: an event is an action of a phase (thesis 5.2.3). */
    public static final String PHASE_ITEM = "PhaseItem";

    /** Markup: an event is an option of the action before it (thesis 5.2.3). */
    public static final String PHASE_BRANCH = "PhaseBranch";

    /** Option of {@link #PHASE_ITEM}, and where it differs from the action's of {@link #PHASE_BRANCH}: text. */
    public static final String PHASE_NAME = "phaseName";

    /** Option of {@link #PHASE_BRANCH}: text on its button. */
    public static final String ACTION_NAME = "actionName";

    /** Option of {@link #PHASE_ITEM} and {@link #PHASE_BRANCH}: an enumeration of who acts. */
    public static final String ACTOR = "actor";

    /** Field of timers: a duration. */
    public static final String DURATION = "duration";

    /** Field of interrupts: text. */
    public static final String INTERRUPT_NAME = "interruptName";

    /** Field of Return Value and Check Return: text. */
    public static final String VALUE = "value";

    /** Field of Generate Tasks: a list, one task per item. */
    public static final String LOCATIONS = "locations";

    /** Field of Generate Tasks: text, the class of the new tasks. */
    public static final String TASK_CLASS = "taskClass";

    /** Field of generated tasks that holds their item of {@link #LOCATIONS}. */
    public static final String LOCATION = "location";

    /** Field of Apply Allocation: a map from task to proxy. */
    public static final String TASKS = "tasks";

    /** Field of Redefine Variables: a variable. */
    public static final String VARIABLE = "variable";

    /** Field of Define Variables: a list of variables. */
    public static final String VARIABLES = "variables";

    /** Field of Select Variable: text, a type as vocabularies write it. */
    public static final String VARIABLE_CLASS = "variableClass";

    /** Field of the answers to Define and Redefine Variables: a map from variable to its new value. */
    public static final String VALUES = "values";

    /** Field of Apply Allocation: a record with a field {@link #TASKS}. */
    public static final String ALLOCATION = "allocation";

    /** Field of a decision whose text becomes the prompt. */
    public static final String QUESTION = "question";

    private Reserved() {}
}
