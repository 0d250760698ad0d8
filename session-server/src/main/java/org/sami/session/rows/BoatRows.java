package org.sami.session.rows;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Base64;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.SettingsReport;
import org.sami.crw.operator.alarm.Alarm;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.boat.UnreachedBoat;
import org.sami.crw.operator.map.MapSnapshot;
import org.sami.crw.operator.map.ShownPath;
import org.sami.crw.operator.map.ShownWayHome;
import org.sami.crw.proxy.status.StopLatch;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** Rows of boats and of their ways. */
final class BoatRows {
    static final int MOST_BOATS = 500;

    private static final long STEP_MS = 1000; // else a boat that stands still would be sent ten times a second
    private static final double TENTHS = 10;

    private BoatRows() {}

    /**
     * The boats.
     *
     * @param drivers who claims a boat, by boat
     */
    static Table boats(
            List<BoatSnapshot> boats, List<UnreachedBoat> unreached, List<Alarm> alarms, Map<String, String> drivers) {
        Map<String, Priority> worst = new HashMap<>();
        alarms.stream()
                .filter(Alarm::sounds)
                .forEach(alarm -> List.of(alarm.boat(), alarm.other())
                        .forEach(boat -> worst.merge(
                                boat,
                                alarm.kind().severity(),
                                (one, other) -> one.compareTo(other) > 0 ? one : other)));
        Table.Builder table = new Table.Builder("boats", MOST_BOATS);
        for (BoatSnapshot boat : boats) {
            ObjectNode row = table.row(boat.boat());
            fill(row, boat);
            Optional.ofNullable(drivers.get(boat.boat())).ifPresent(driver -> row.put("driver", driver));
            Optional.ofNullable(worst.get(boat.boat())).ifPresent(severity -> row.put("alarm", word(severity)));
        }
        for (UnreachedBoat boat : unreached) {
            table.row(boat.name())
                    .put("link", "unreached")
                    .put("commander", "unknown")
                    .put("why", Table.Builder.cut(boat.sentence()))
                    .put("moving", false)
                    .put("stopped", false)
                    .put("flies", false);
        }
        return table.build();
    }

    private static void fill(ObjectNode row, BoatSnapshot boat) {
        boat.pose().ifPresent(pose -> {
            row.put("lat", Shapes.rounded(pose.position().latDeg()));
            row.put("lon", Shapes.rounded(pose.position().lonDeg()));
            if (boat.flies()) {
                row.put("alt", Math.round(pose.position().altM() * TENTHS) / TENTHS);
            }
            row.put("heading", Math.round(Math.toDegrees(pose.headingRad()) * TENTHS) / TENTHS);
            row.put("at", boat.poseAtMillis() / STEP_MS * STEP_MS);
        });
        boat.speedMps().ifPresent(speed -> row.put("speed", Math.round(speed * TENTHS) / TENTHS));
        boat.heardAtMillis().ifPresent(at -> row.put("heard", at / STEP_MS * STEP_MS));
        boat.battery().ifPresent(battery -> {
            row.put("battery", Math.round(battery.percent()));
            row.put("batteryLevel", word(battery.level()));
        });
        row.put("link", word(boat.link()));
        boat.mode().ifPresent(mode -> row.put("mode", word(mode)));
        row.put("commander", word(boat.commander()));
        row.put("why", Table.Builder.cut(boat.why().text()));
        row.put("moving", boat.why().shouldMove());
        row.put("stopped", boat.stop().where() != StopLatch.Where.NOWHERE);
        row.put("flies", boat.flies());
        if (boat.stop().where() != StopLatch.Where.NOWHERE) {
            row.put("stop", word(boat.stop().where()));
            Table.Builder.put(row, "stoppedBy", boat.stop().by());
        }
    }

    /** The settings in force on boats, as the message of the boats' link that reports them, in Base64. */
    static Table settings(List<BoatSnapshot> boats) {
        Table.Builder table = new Table.Builder("settings", MOST_BOATS);
        for (BoatSnapshot boat : boats) {
            boat.settings().ifPresent(settings -> {
                SettingsReport report = new SettingsReport(
                                settings.heading(),
                                settings.speed(),
                                settings.velocityMultiplier(),
                                settings.lostLinkAction(),
                                Optional.empty(),
                                Optional.empty(),
                                "",
                                settings.board())
                        .with(settings.performance())
                        .with(settings.capabilities())
                        .withActionBy(settings.lostLinkBy());
                table.row(boat.boat()).put("report", Base64.getEncoder().encodeToString(LinkCodec.body(report)));
            });
        }
        return table.build();
    }

    /** The ways that boats go now, or are expected to go home. */
    static Table paths(MapSnapshot map) {
        Map<String, List<GeoPoint>> ways = new TreeMap<>();
        map.paths().stream().filter(ShownPath::current).forEach(path -> ways.put(path.boat(), path.ahead()));
        for (ShownWayHome way : map.waysHome()) {
            ways.put(way.boat(), way.points());
        }
        Table.Builder table = new Table.Builder("paths", MOST_BOATS);
        ways.forEach((boat, points) -> {
            if (!points.isEmpty()) {
                table.row(boat).set("points", Shapes.points(points));
            }
        });
        return table.build();
    }

    /** A constant as messages name it: {@code this-base}. */
    static String word(Enum<?> constant) {
        return constant.name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
