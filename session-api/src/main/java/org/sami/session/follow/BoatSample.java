package org.sami.session.follow;

import java.util.Objects;
import java.util.Optional;
import java.util.OptionalLong;
import org.sami.boat.link.BoatMode;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.proxy.status.BatteryState;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.proxy.status.BoatTuning;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.proxy.status.StopLatch;

/**
 * What a session that is followed knows of a boat at a moment, besides its commands. Times are milliseconds on the session's clock.
 *
 * @param atMillis the moment
 * @param heardAtMillis time of the last frame; empty before the first
 * @param pose empty before the first report
 * @param poseAtMillis time of that report; 0 before the first
 * @param shouldMove whether it should be under way
 * @param why why it moves or does not, one sentence
 */
public record BoatSample(
        long atMillis,
        String boat,
        LinkState link,
        OptionalLong heardAtMillis,
        Optional<BoatPose> pose,
        long poseAtMillis,
        Optional<BatteryState> battery,
        Optional<BoatMode> mode,
        BoatSnapshot.Commander commander,
        boolean shouldMove,
        String why,
        StopLatch stop,
        Optional<BoatTuning> settings,
        boolean flies) {
    public BoatSample {
        Objects.requireNonNull(boat, "boat");
        Objects.requireNonNull(link, "link");
        Objects.requireNonNull(heardAtMillis, "heardAtMillis");
        Objects.requireNonNull(pose, "pose");
        Objects.requireNonNull(battery, "battery");
        Objects.requireNonNull(mode, "mode");
        Objects.requireNonNull(commander, "commander");
        Objects.requireNonNull(why, "why");
        Objects.requireNonNull(stop, "stop");
        Objects.requireNonNull(settings, "settings");
    }
}
