package org.sami.session.client;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalLong;
import org.sami.boat.link.BatteryLevel;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.SettingsReport;
import org.sami.crw.message.MessageEntry;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.operator.alarm.Alarm;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.boat.UnreachedBoat;
import org.sami.crw.operator.health.HealthEntry;
import org.sami.crw.operator.health.HealthFault;
import org.sami.crw.operator.health.HealthKind;
import org.sami.crw.operator.mission.StuckMission;
import org.sami.crw.proxy.status.BatteryState;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.proxy.status.BoatTuning;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.proxy.status.StopLatch;
import org.sami.session.follow.BoatSample;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** Reads rows of a session as what models show. */
final class LinkRowReader {
    private LinkRowReader() {}

    /** A boat's; empty for one that has never answered. */
    static Optional<BoatSample> boat(JsonNode row, long nowMillis, Optional<BoatTuning> settings) {
        if (row.path("link").asText().equals("unreached")) {
            return Optional.empty();
        }
        Optional<BoatPose> pose = row.has("lat")
                ? Optional.of(new BoatPose(
                        new GeoPoint(
                                row.path("lat").asDouble(),
                                row.path("lon").asDouble(),
                                row.path("alt").asDouble()),
                        Math.toRadians(row.path("heading").asDouble()),
                        row.path("speed").asDouble(),
                        row.path("at").asLong()))
                : Optional.empty();
        Optional<BatteryState> battery = row.has("battery")
                ? Optional.of(new BatteryState(
                        row.path("battery").asDouble(), constant(BatteryLevel.class, row.path("batteryLevel"))))
                : Optional.empty();
        return Optional.of(new BoatSample(
                nowMillis,
                row.path("id").asText(),
                constant(LinkState.class, row.path("link")),
                row.has("heard") ? OptionalLong.of(row.path("heard").asLong()) : OptionalLong.empty(),
                pose,
                row.path("at").asLong(),
                battery,
                row.has("mode") ? Optional.of(constant(BoatMode.class, row.path("mode"))) : Optional.empty(),
                constant(BoatSnapshot.Commander.class, row.path("commander")),
                row.path("moving").asBoolean(),
                row.path("why").asText(),
                stop(row),
                settings,
                row.path("flies").asBoolean()));
    }

    /** The settings in force on a boat; empty where this program cannot read them. */
    static Optional<BoatTuning> settings(JsonNode row) {
        try {
            LinkMessage report = LinkCodec.readBody(
                    Base64.getDecoder().decode(row.path("report").asText()));
            return report instanceof SettingsReport settings ? Optional.of(BoatTuning.of(settings)) : Optional.empty();
        } catch (LinkException | IllegalArgumentException unreadable) {
            return Optional.empty();
        }
    }

    private static StopLatch stop(JsonNode row) {
        return switch (row.path("stop").asText()) {
            case "here" -> StopLatch.HERE;
            case "elsewhere" -> StopLatch.elsewhere(row.path("stoppedBy").asText());
            case "overridden" -> StopLatch.overridden(row.path("stoppedBy").asText());
            default -> StopLatch.NONE;
        };
    }

    static MessageEntry message(JsonNode row) {
        return new MessageEntry(
                row.path("id").asLong(),
                new OperatorMessage(
                        row.path("at").asLong(),
                        row.path("mission").asLong(),
                        constant(OperatorMessage.Source.class, row.path("source")),
                        constant(Priority.class, row.path("priority")),
                        row.path("text").asText(),
                        texts(row.path("boats")),
                        row.path("keyword").asText()),
                row.path("count").asInt(1),
                row.path("acknowledged").asBoolean(),
                false);
    }

    static Alarm alarm(JsonNode row) {
        return new Alarm(
                row.path("id").asLong(),
                constant(Alarm.Kind.class, row.path("kind")),
                row.path("boat").asText(),
                row.path("other").asText(),
                row.path("text").asText(),
                row.path("since").asLong(),
                row.path("active").asBoolean(),
                row.path("acknowledged").asBoolean(),
                false);
    }

    static HealthEntry fault(JsonNode row) {
        return new HealthEntry(
                row.path("id").asLong(),
                new HealthFault(
                        constant(HealthKind.class, row.path("kind")),
                        row.path("subject").asText(),
                        constant(Priority.class, row.path("severity")),
                        row.path("text").asText(),
                        row.path("advice").asText(),
                        row.path("details").asText(),
                        row.path("boat").asText(),
                        row.path("mission").asLong()),
                row.path("since").asLong());
    }

    static StuckMission stuck(JsonNode row) {
        return new StuckMission(
                row.path("id").asLong(),
                row.path("root").asLong(),
                row.path("title").asText(),
                row.path("since").asLong(),
                row.path("what").asText(),
                row.path("help").asText(),
                texts(row.path("boats")),
                row.path("again").asBoolean() ? List.of(0L) : List.of()); // which is known to the session
    }

    static UnreachedBoat unreached(JsonNode row) {
        return new UnreachedBoat(
                row.path("id").asText(),
                row.path("boat").asText(),
                row.path("reason").asText(),
                row.path("refused").asBoolean(),
                row.path("tries").asLong(),
                row.path("since").asLong());
    }

    static List<String> texts(JsonNode list) {
        List<String> texts = new ArrayList<>();
        list.forEach(one -> texts.add(one.asText()));
        return texts;
    }

    /** The constant that messages name {@code this-base}. */
    private static <E extends Enum<E>> E constant(Class<E> of, JsonNode word) {
        return Enum.valueOf(of, word.asText().toUpperCase(Locale.ROOT).replace('-', '_'));
    }
}
