package org.sami.spn.json;

import java.util.List;
import org.sami.spn.finding.Advice;

/** Why what readers refuse matters, and how it is mended. */
public final class ReaderAdvice {
    /** For each code of a reader, in the order of {@code docs/file-format.md}. */
    public static final List<Advice> ALL = List.of(
            new Advice(
                    Codes.SYNTAX,
                    "The text is not JSON as it stands, so nothing behind that place was read.",
                    "Correct the text at that line and column: most often a comma, quote or bracket is missing."),
            new Advice(
                    Codes.FILE,
                    "Without the file there is nothing to read.",
                    "Check the name and folder of the file and whether you may read it."),
            new Advice(
                    Codes.VERSION,
                    "The file was written for another version of the format: its members may mean something else.",
                    "Open it with the program that wrote it, or a newer one, and save it anew."),
            new Advice(
                    Codes.DOMAIN,
                    "The plan was written for other events and robots than those of this domain.",
                    "Choose the domain of the file, with --domain or in the settings."),
            new Advice(Codes.MISSING, "What the member says cannot be guessed.", "Add the member."),
            new Advice(
                    Codes.UNKNOWN_MEMBER,
                    "Nobody reads the member: what it says would be lost.",
                    "Correct its name, or delete it."),
            new Advice(
                    Codes.WRONG_TYPE,
                    "The value has another shape than the reader expects there, such as a text for a number.",
                    "Write a value of the kind that the message names."),
            new Advice(
                    Codes.UNKNOWN_WORD,
                    "The word means nothing there.",
                    "Choose one of the words that the format has there."),
            new Advice(
                    Codes.BAD_VALUE,
                    "The value is outside what is allowed there.",
                    "Write a value that is allowed; the message names the range."),
            new Advice(
                    Codes.UNKNOWN_TYPE,
                    "Nobody can read or write values of a type that is not there.",
                    "Choose a type of the domain, or correct the name."),
            new Advice(
                    Codes.DUPLICATE,
                    "Two elements with one name: nobody knows which is meant.",
                    "Rename one of them, or delete it."),
            new Advice(
                    Codes.DANGLING,
                    "The edge, order or layout speaks of an element that is not there: the plan cannot be run.",
                    "Delete it, or add the element."),
            new Advice(
                    Codes.REQUIREMENT,
                    "The words of the requirement mean nothing together.",
                    "Choose a match, a kind of token and a number that belong together; see the table of "
                            + "requirements."),
            new Advice(
                    Codes.UNKNOWN_EVENT,
                    "The domain has no such event: nobody can carry it out or send it.",
                    "Choose an event of the domain, or correct the name."),
            new Advice(
                    Codes.EVENT_SIDE,
                    "Output events stand on places and input events on transitions: there it is never looked at.",
                    "Move the event to the other kind of vertex."),
            new Advice(
                    Codes.UNKNOWN_FIELD,
                    "The event has no such field: the value reaches nobody.",
                    "Correct the name of the field, or delete it."),
            new Advice(
                    Codes.UNKNOWN_MARKUP,
                    "The domain has no such markup: no screen shows it.",
                    "Choose a markup of the domain, or delete it."),
            new Advice(
                    Codes.UNKNOWN_OPTION,
                    "The markup has no such option: no screen shows it.",
                    "Choose an option of the markup, or delete it."),
            new Advice(
                    Codes.UNKNOWN_PLAN,
                    "There is no such plan in the project: the sub-mission cannot begin.",
                    "Correct the id, or add the plan to the project."),
            new Advice(
                    Codes.UNKNOWN_TASK,
                    "There is no task of that name or class: nobody can be given it.",
                    "Correct the name, or add the task to the plan."),
            new Advice(
                    Codes.VARIABLE_NAME,
                    "A name that is none cannot be read back.",
                    "Use letters, digits and underscores, with a letter first."),
            new Advice(
                    Codes.ANSWERS,
                    "A plan that waits for the answer would wait for an event that cannot come.",
                    "Let the output event name input events of the vocabulary as its answers."),
            new Advice(
                    Codes.DECISION,
                    "The form of the question and its answers contradict each other: no dialog can be made of it.",
                    "Let the decision use answers and a form that the event has."),
            new Advice(
                    Codes.UNKNOWN_GLOBAL,
                    "A value that nobody declares is not saved: the next mission does not have it.",
                    "Declare the variable in the file, or delete the value."));

    private ReaderAdvice() {}
}
