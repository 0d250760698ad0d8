package org.sami.spn.legacy;

import java.util.List;
import org.sami.spn.finding.Advice;

/** Why what an import finds matters, and how it is mended; codes that it shares with readers of files are explained there. */
public final class LegacyAdvice {
    /** For each code that only an import has. */
    public static final List<Advice> ALL = List.of(
            new Advice(
                    LegacyCodes.FORMAT,
                    "The file is no export of the earlier system: nothing in it can be taken for a plan.",
                    "Export the project with the earlier system again, as docs/import-legacy.md says."),
            new Advice(
                    LegacyCodes.UNREADABLE,
                    "What came of the import could not be read back, so nothing was written.",
                    "Import without the plan that the message names, and report the export."),
            new Advice(
                    LegacyCodes.CYCLE,
                    "The plan would start itself without end.",
                    "Take the sub-mission out of the plan in the earlier system, and export it again."),
            new Advice(
                    LegacyCodes.TABLE,
                    "The table of names that the import uses cannot be read.",
                    "Correct the table at the place that the message names."),
            new Advice(
                    LegacyCodes.UNKNOWN_MEMBER,
                    "Nobody here reads what the member says: it was not imported.",
                    "Look in the earlier system at what it says; draw it here if the plan needs it."),
            new Advice(
                    LegacyCodes.UNKNOWN_EVENT,
                    "The domain has no such event: nobody would carry it out or send it.",
                    "Choose an event of the domain that does the same."),
            new Advice(
                    LegacyCodes.UNKNOWN_FIELD,
                    "The event has no such field here: its value was not imported.",
                    "Give the value to the field of this domain that means the same."),
            new Advice(
                    LegacyCodes.UNKNOWN_MARKUP,
                    "No screen here shows the markup: it was not imported.",
                    "Choose a markup of the domain that shows the same."),
            new Advice(
                    LegacyCodes.UNKNOWN_OPTION,
                    "The markup has no such option here: it was not imported.",
                    "Choose an option of the markup that shows the same."),
            new Advice(
                    LegacyCodes.UNKNOWN_CLASS,
                    "The domain has no such class of tasks or values.",
                    "Choose a class of the domain, or add it to the domain."),
            new Advice(
                    LegacyCodes.BY_NAME,
                    "What the export names by a class is found here by its name: it may be another one.",
                    "Look once whether the event named is the one that was meant."),
            new Advice(
                    LegacyCodes.EVENT_SIDE,
                    "Output events stand on places and input events on transitions: this one was never looked at.",
                    "Put the event on the other kind of vertex, if the plan needs it."),
            new Advice(
                    LegacyCodes.VALUE,
                    "The value is none that the field can have: the operator is asked for it instead.",
                    "Give the field a value here, or leave it to be asked."),
            new Advice(
                    LegacyCodes.NO_REQUIREMENT,
                    "The edge had no requirement and got one that does what the earlier system did.",
                    "Look whether the requirement says what was meant."),
            new Advice(
                    LegacyCodes.REQUIREMENT,
                    "The requirement is written otherwise here: it may take other tokens.",
                    "Look whether the requirement says what was meant."),
            new Advice(
                    LegacyCodes.PARALLEL_EDGE,
                    "Two edges between the same vertices are one edge here.",
                    "Look whether the requirements of both are on the one edge."),
            new Advice(
                    LegacyCodes.ORDER,
                    "Transitions were looked at in another order than they stand here.",
                    "Look whether the order matters where two transitions take from one place."),
            new Advice(
                    LegacyCodes.VARIABLE,
                    "The text looks like a variable and is not used as one.",
                    "Write the name of the variable with @, if one was meant."),
            new Advice(
                    LegacyCodes.VARIABLE_TYPE,
                    "One variable with two types: what reads it may get a value that it cannot use.",
                    "Use two variables."),
            new Advice(
                    LegacyCodes.PREFIX,
                    "A copied plan names a variable without the prefix of the copy: giving it a value changes "
                            + "nothing.",
                    "Name the variable as the copy does."),
            new Advice(
                    LegacyCodes.MOVES_NOBODY,
                    "News names robots and the transition moves none of them: they stay where they are.",
                    "Let the edges of the transition take relevant tokens, if they are to go on."),
            new Advice(
                    LegacyCodes.MODE,
                    "The mode of an edge or event has no counterpart here and makes no difference to a run.",
                    "Nothing has to be done."),
            new Advice(
                    LegacyCodes.DROPPED,
                    "Something that makes no difference to a run was not kept.",
                    "Nothing has to be done."),
            new Advice(
                    LegacyCodes.HEADING,
                    "A plan without a start is a heading or a draft: it cannot be run.",
                    "Delete it here, or mark its start."),
            new Advice(
                    LegacyCodes.COPY_FOLDED,
                    "A copy of a plan became a reference to the plan: a change of the plan now changes it "
                            + "everywhere.",
                    "Nothing has to be done."),
            new Advice(
                    LegacyCodes.COPY_KEPT,
                    "The copy differs from its plan, so it stays a plan of its own.",
                    "If the difference was not meant, put the plan itself in its place."),
            new Advice(
                    LegacyCodes.NOT_A_COPY,
                    "The name says that it is a copy, and no plan of that name is there.",
                    "Rename it, if the name misleads."),
            new Advice(
                    LegacyCodes.LEFT_BEHIND,
                    "What the editor of the earlier system left behind of deleted elements was not imported.",
                    "Nothing has to be done."));

    private LegacyAdvice() {}
}
