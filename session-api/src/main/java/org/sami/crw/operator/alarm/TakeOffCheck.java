package org.sami.crw.operator.alarm;

import java.util.Comparator;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sami.boat.link.LinkDefaults;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.operator.alarm.LaunchCheck.Item;
import org.sami.crw.operator.alarm.LaunchCheck.State;
import org.sami.crw.operator.alarm.LaunchCheck.Subject;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.spn.value.GeoPoint;

/** The items of {@link LaunchCheck} that only robots that fly have. */
final class TakeOffCheck {
    /** Autopilots repeat every 30 s what keeps them from arming. */
    private static final long REPEATED_WITHIN_MS = 40_000;

    private static final double ON_GROUND_M = 0.5; // a barometer is off by less

    private static final Pattern AGAINST_ARMING = Pattern.compile("\\b(?:PreArm|Arm): .+");

    private TakeOffCheck() {}

    /** Its home is where its motors are started: a position is all that it needs of it on the ground. */
    static Item position(BoatSnapshot copter, LaunchFacts known) {
        if (copter.pose().isEmpty()) {
            return new Item(Subject.POSITION, State.UNKNOWN, "it has not said where it is");
        }
        Optional<String> wrong = known.alarm(copter.boat(), Alarm.Kind.POSITION_DOUBTFUL);
        if (wrong.isPresent()) {
            return new Item(Subject.POSITION, State.BAD, wrong.get());
        }
        GeoPoint at = copter.pose().get().position();
        long age = copter.poseAgeMillis(known.nowMillis()).orElse(0);
        if (age > LinkDefaults.LINK_LOST_AFTER_MS) {
            return new Item(Subject.POSITION, State.BAD, LaunchCheck.old(at, age));
        }
        String home = at.altM() < ON_GROUND_M ? ", its home once its motors are started" : ", in the air";
        return new Item(Subject.POSITION, State.GOOD, LaunchCheck.words(at) + home);
    }

    /** What its autopilot has said lately against starting its motors. */
    static Item autopilot(BoatSnapshot copter, LaunchFacts known) {
        if (copter.heardAtMillis().isEmpty()) {
            return new Item(Subject.AUTOPILOT, State.UNKNOWN, "it has not answered yet");
        }
        return against(copter, known)
                .map(text -> new Item(Subject.AUTOPILOT, State.BAD, text))
                .orElseGet(() -> new Item(Subject.AUTOPILOT, State.GOOD, "says nothing against starting the motors"));
    }

    private static Optional<String> against(BoatSnapshot copter, LaunchFacts known) {
        return known.messages().stream()
                .filter(message -> message.boats().contains(copter.boat())
                        && known.nowMillis() - message.atMillis() <= REPEATED_WITHIN_MS
                        && AGAINST_ARMING.matcher(message.text()).find())
                .max(Comparator.comparingLong(OperatorMessage::atMillis))
                .map(message -> {
                    Matcher found = AGAINST_ARMING.matcher(message.text());
                    return found.find() ? found.group() : message.text();
                });
    }

    /** Where it is, and where its commands send it. */
    static Item area(BoatSnapshot copter, LaunchFacts known) {
        Optional<String> wrong =
                known.alarm(copter.boat(), Alarm.Kind.FENCE).or(() -> known.alarm("", Alarm.Kind.FENCE));
        if (wrong.isPresent()) {
            return new Item(Subject.AREA, State.BAD, wrong.get());
        } else if (copter.pose().isEmpty()) {
            return new Item(Subject.AREA, State.UNKNOWN, "it has not said where it is");
        }
        return known.alarm(copter.boat(), Alarm.Kind.FENCE_AHEAD)
                .map(text -> new Item(Subject.AREA, State.DOUBTFUL, text))
                .orElseGet(() -> new Item(Subject.AREA, State.GOOD, "inside the fence, and in no no-go area"));
    }
}
