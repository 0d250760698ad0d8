package org.sami.crw.operator.health;

import java.util.Objects;
import org.sami.crw.fleet.RobotKind;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Priority;

/**
 * A lasting fault, as its finder reports it. Two faults of one kind and one subject are the same fault, possibly in other words.
 *
 * @param subject the subject, for people and with the kind as a key: a boat's id, an address, a mission's title with its number, a file; empty
 *     text where the session has only one of the kind
 * @param text the fault, one sentence without a full stop at its end
 * @param advice what the operator can do, one sentence without a full stop at its end
 * @param boat id of the boat concerned; empty text for none, or where its id is unknown
 * @param mission the mission concerned, or {@link Ids#NONE}
 */
public record HealthFault(
        HealthKind kind,
        String subject,
        Priority severity,
        String text,
        String advice,
        String details,
        String boat,
        long mission) {
    public HealthFault {
        Objects.requireNonNull(kind, "kind");
        Objects.requireNonNull(subject, "subject");
        Objects.requireNonNull(severity, "severity");
        Objects.requireNonNull(text, "text");
        Objects.requireNonNull(advice, "advice");
        Objects.requireNonNull(details, "details");
        Objects.requireNonNull(boat, "boat");
    }

    /** A fault of the session itself, of which there is one of its kind. */
    public static HealthFault ofSession(HealthKind kind, Priority severity, String text, String advice) {
        return new HealthFault(kind, "", severity, text, advice, "", "", Ids.NONE);
    }

    /** A fault of a file, an address or something else that is neither boat nor mission. */
    public static HealthFault of(HealthKind kind, String subject, Priority severity, String text, String advice) {
        return new HealthFault(kind, subject, severity, text, advice, "", "", Ids.NONE);
    }

    /** A fault that concerns a boat. */
    public static HealthFault ofBoat(HealthKind kind, String boat, Priority severity, String text, String advice) {
        return new HealthFault(kind, boat, severity, text, advice, "", boat, Ids.NONE);
    }

    /** A fault of a mission. */
    public static HealthFault ofMission(long mission, String title, Priority severity, String text, String advice) {
        return new HealthFault(
                HealthKind.MISSION, title + " (" + mission + ")", severity, text, advice, "", "", mission);
    }

    /** The same with what explains it. */
    public HealthFault withDetails(String explained) {
        return new HealthFault(kind, subject, severity, text, advice, explained, boat, mission);
    }

    /** The same in words about robots of a kind. */
    public HealthFault inWordsFor(RobotKind robots) {
        return new HealthFault(
                kind, subject, severity, robots.say(text), robots.say(advice), robots.say(details), boat, mission);
    }

    /** All that is known of it, in sentences: what is wrong, what to do, the details. */
    public String whole() {
        return text + ". " + advice + "." + (details.isEmpty() ? "" : " " + details + ".");
    }
}
