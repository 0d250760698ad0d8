package org.sami.crw.operator.alarm;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.boat.link.LostLinkAction;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.message.OperatorMessage;

/**
 * What a session knows besides its boats that counts for {@link LaunchCheck}.
 *
 * @param robots what the session's plans command
 * @param messages to the operator
 * @param lostLinkWish what boats are to do when their link is lost; empty where nothing is wished
 * @param nowMillis the session's time
 */
public record LaunchFacts(
        RobotKind robots,
        List<Alarm> alarms,
        List<OperatorMessage> messages,
        Optional<LostLinkAction> lostLinkWish,
        long nowMillis) {
    public LaunchFacts {
        Objects.requireNonNull(robots, "robots");
        alarms = List.copyOf(alarms);
        messages = List.copyOf(messages);
        Objects.requireNonNull(lostLinkWish, "lostLinkWish");
    }

    /** The text of an alarm of a kind about a boat that is active; empty text for the boat means about none. */
    Optional<String> alarm(String boat, Alarm.Kind kind) {
        return alarms.stream()
                .filter(alarm ->
                        alarm.active() && alarm.kind() == kind && alarm.boat().equals(boat))
                .map(Alarm::text)
                .findFirst();
    }
}
