package org.sami.boat.app.screen;

import android.content.res.Resources;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.sami.boat.app.R;
import org.sami.boat.app.boat.PhoneHealth;
import org.sami.boat.app.boat.PhoneStatus;
import org.sami.boat.app.screen.StatusRow.Level;
import org.sami.boat.hull.board.BoardState;
import org.sami.boat.hull.position.Pose;
import org.sami.boat.hull.position.PositionDoubt;
import org.sami.boat.link.BatteryDefaults;

/** Puts the state of the boat into words. */
final class StatusRows {
    private static final double SHARP_M = 5;

    private final Resources texts;

    StatusRows(Resources texts) {
        this.texts = texts;
    }

    /**
     * The lines, troubles first.
     *
     * @param address of the phone in its network; empty if it is in none
     */
    List<StatusRow> of(PhoneStatus boat, String address) {
        List<StatusRow> rows = new ArrayList<>();
        for (String trouble : boat.troubles()) {
            rows.add(row(R.string.trouble, trouble, Level.BAD));
        }
        rows.add(link(boat, address));
        rows.add(commander(boat));
        rows.add(gps(boat));
        rows.add(compass(boat));
        rows.add(board(boat));
        rows.add(battery(boat));
        rows.add(phone(boat));
        return rows;
    }

    private StatusRow link(PhoneStatus boat, String address) {
        if (address.isEmpty()) {
            return row(R.string.link, texts.getString(R.string.no_network), Level.BAD);
        }
        String at = address + ":" + boat.port();
        switch (boat.serving()) {
            case WAITS_FOR_POSITION:
                return row(R.string.link, texts.getString(R.string.waits_for_gps, at), Level.DOUBTFUL);
            case FAILED:
                return row(R.string.link, texts.getString(R.string.not_serving, at), Level.BAD);
            default:
                if (boat.areLinksOpen()) {
                    return row(R.string.link, texts.getString(R.string.open_to_all, at), Level.DOUBTFUL);
                }
                if (boat.bases() == 0) {
                    return row(R.string.link, texts.getString(R.string.nobody_paired, at), Level.BAD);
                }
                String clients = texts.getQuantityString(R.plurals.connected, boat.clients(), boat.clients());
                return row(R.string.link, at + "\n" + clients, boat.clients() > 0 ? Level.GOOD : Level.DOUBTFUL);
        }
    }

    private StatusRow commander(PhoneStatus boat) {
        String mode = boat.mode().map(now -> now.name().replace('_', ' ')).orElse("");
        if (!boat.commandedBy().isPresent()) {
            return row(
                    R.string.commander,
                    (texts.getString(R.string.nobody) + "\n" + mode).trim(),
                    boat.mode().isPresent() ? Level.DOUBTFUL : Level.GOOD);
        }
        return row(R.string.commander, boat.commandedBy().get() + "\n" + mode, Level.GOOD);
    }

    private StatusRow gps(PhoneStatus boat) {
        Pose pose = boat.pose();
        if (boat.doubts().contains(PositionDoubt.GPS_IMPLAUSIBLE)) {
            return row(R.string.gps, PositionDoubt.GPS_IMPLAUSIBLE.words(), Level.BAD);
        }
        if (!pose.isLocated() || boat.doubts().contains(PositionDoubt.NO_GPS)) {
            return row(R.string.gps, texts.getString(R.string.no_gps), Level.BAD);
        }
        String value = texts.getString(R.string.position, pose.latDeg(), pose.lonDeg(), pose.positionErrorM());
        return row(R.string.gps, value, pose.positionErrorM() <= SHARP_M ? Level.GOOD : Level.DOUBTFUL);
    }

    private StatusRow compass(PhoneStatus boat) {
        Pose pose = boat.pose();
        Set<PositionDoubt> doubts = boat.doubts();
        if (!pose.isComplete()) {
            return row(R.string.compass, texts.getString(R.string.no_heading), Level.BAD);
        }
        int degrees = (int) Math.floorMod(Math.round(Math.toDegrees(pose.headingRad())), 360L);
        String value = texts.getString(R.string.heading, degrees);
        if (doubts.contains(PositionDoubt.COMPASS_DISAGREES)) {
            return row(R.string.compass, value + "\n" + PositionDoubt.COMPASS_DISAGREES.words(), Level.BAD);
        }
        if (doubts.contains(PositionDoubt.NO_COMPASS)) {
            return row(R.string.compass, value + "\n" + PositionDoubt.NO_COMPASS.words(), Level.DOUBTFUL);
        }
        return row(R.string.compass, value, Level.GOOD);
    }

    private StatusRow board(PhoneStatus boat) {
        return boat.board() == BoardState.CONNECTED
                ? row(R.string.board, texts.getString(R.string.board_reports), Level.GOOD)
                : row(R.string.board, boat.boardTrouble(), Level.BAD);
    }

    private StatusRow battery(PhoneStatus boat) {
        if (Double.isNaN(boat.boardVolts())) {
            return row(R.string.battery, texts.getString(R.string.unknown), Level.DOUBTFUL);
        }
        String value = texts.getString(R.string.charge, boat.boardPercent(), boat.boardVolts());
        return row(
                R.string.battery,
                value,
                level(boat.boardPercent(), BatteryDefaults.LOW_PERCENT, BatteryDefaults.CRITICAL_PERCENT));
    }

    private StatusRow phone(PhoneStatus boat) {
        if (Double.isNaN(boat.phonePercent())) {
            return row(R.string.phone, texts.getString(R.string.unknown), Level.DOUBTFUL);
        }
        return row(
                R.string.phone,
                texts.getString(R.string.percent, boat.phonePercent()),
                level(boat.phonePercent(), 2 * PhoneHealth.LITTLE_CHARGE_PERCENT, PhoneHealth.LITTLE_CHARGE_PERCENT));
    }

    private static Level level(double percent, double low, double critical) {
        return percent >= low ? Level.GOOD : percent >= critical ? Level.DOUBTFUL : Level.BAD;
    }

    private StatusRow row(int label, String value, Level level) {
        return new StatusRow(texts.getString(label), value, level);
    }
}
