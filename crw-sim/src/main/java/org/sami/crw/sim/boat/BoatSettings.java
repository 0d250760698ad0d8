package org.sami.crw.sim.boat;

import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.server.BoatServerDefaults;
import org.sami.boat.server.ServerConfig;
import org.sami.boat.server.log.LogPlace;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.hull.HullConfig;
import org.sami.spn.value.GeoPoint;

/**
 * What is set for one simulated boat.
 *
 * @param name the boat's id; letters, digits, dots, hyphens and underscores, as it also names files
 * @param address where its server listens; port 0 takes a free one
 * @param at where the hull lies at the start
 * @param seed of all that is random about the hull
 * @param batteryPercent charge at the start
 * @param conditions on its water
 * @param fieldSeed of what there is to be measured; equal for all boats of one water
 * @param lostLink what it does when its link is lost, until a command sets something else
 * @param logFolder where its log is kept, and taken up again after a restart; none if empty
 * @param logBytes most bytes of its log
 * @param pictureFolder where its pictures are kept; none if empty
 */
public record BoatSettings(
        String name,
        InetSocketAddress address,
        GeoPoint at,
        long seed,
        double batteryPercent,
        HullConfig hull,
        Conditions conditions,
        long fieldSeed,
        LostLinkAction lostLink,
        Optional<Path> logFolder,
        long logBytes,
        Optional<Path> pictureFolder) {

    /** A boat that keeps its pictures next to its log, if it keeps one. */
    public BoatSettings(
            String name,
            InetSocketAddress address,
            GeoPoint at,
            long seed,
            double batteryPercent,
            HullConfig hull,
            Conditions conditions,
            long fieldSeed,
            LostLinkAction lostLink,
            Optional<Path> logFolder,
            long logBytes) {
        this(
                name,
                address,
                at,
                seed,
                batteryPercent,
                hull,
                conditions,
                fieldSeed,
                lostLink,
                logFolder,
                logBytes,
                logFolder.map(folder -> folder.resolve(name + "-pictures")));
    }

    /** Refuses a name that cannot name a file, and a charge that is none. */
    public BoatSettings {
        checkName(name);
        Objects.requireNonNull(address, "address");
        Objects.requireNonNull(at, "at");
        Objects.requireNonNull(hull, "hull");
        Objects.requireNonNull(conditions, "conditions");
        Objects.requireNonNull(lostLink, "lostLink");
        Objects.requireNonNull(logFolder, "logFolder");
        Objects.requireNonNull(pictureFolder, "pictureFolder");
        if (!(batteryPercent >= 0 && batteryPercent <= 100)) {
            throw new IllegalArgumentException("a charge of " + batteryPercent + " %");
        }
    }

    /** Refuses a name that cannot name a file. */
    public static void checkName(String name) {
        if (!name.matches("[A-Za-z0-9._-]{1,100}") || name.startsWith(".")) {
            throw new IllegalArgumentException("a boat cannot be named '" + name
                    + "': letters, digits, dots, hyphens and underscores, at most 100, not beginning with a dot");
        }
    }

    /** A boat of the fleet with a full battery, without a log. */
    public static BoatSettings of(String name, InetSocketAddress address, GeoPoint at, long seed) {
        return new BoatSettings(
                name,
                address,
                at,
                seed,
                100,
                HullConfig.DEFAULT,
                Conditions.CALM,
                1,
                LostLinkAction.HOLD,
                Optional.empty(),
                BoatServerDefaults.LOG_BYTES);
    }

    /** The same of another kind; copters return and land when their link is lost. */
    public BoatSettings of(RobotKind robots) {
        return new BoatSettings(
                name,
                address,
                at,
                seed,
                batteryPercent,
                HullConfig.of(robots),
                conditions,
                fieldSeed,
                robots == RobotKind.COPTER ? LostLinkAction.RETURN : lostLink,
                logFolder,
                logBytes,
                pictureFolder);
    }

    /** The same with a log in a folder, of the usual size. */
    public BoatSettings loggingTo(Path folder) {
        return loggingTo(folder, BoatServerDefaults.LOG_BYTES);
    }

    /** The same with a log in a folder, of so many bytes at most. */
    public BoatSettings loggingTo(Path folder, long bytes) {
        return new BoatSettings(
                name,
                address,
                at,
                seed,
                batteryPercent,
                hull,
                conditions,
                fieldSeed,
                lostLink,
                Optional.of(folder),
                bytes);
    }

    /** The same with pictures kept in a folder. */
    public BoatSettings withPicturesIn(Path folder) {
        return new BoatSettings(
                name,
                address,
                at,
                seed,
                batteryPercent,
                hull,
                conditions,
                fieldSeed,
                lostLink,
                logFolder,
                logBytes,
                Optional.of(folder));
    }

    /** The same with another charge at the start. */
    public BoatSettings withBatteryPercent(double percent) {
        return new BoatSettings(
                name,
                address,
                at,
                seed,
                percent,
                hull,
                conditions,
                fieldSeed,
                lostLink,
                logFolder,
                logBytes,
                pictureFolder);
    }

    /** The same on other water. */
    public BoatSettings on(Conditions water) {
        return new BoatSettings(
                name,
                address,
                at,
                seed,
                batteryPercent,
                hull,
                water,
                fieldSeed,
                lostLink,
                logFolder,
                logBytes,
                pictureFolder);
    }

    /** Where the boat's log is kept. */
    public Optional<LogPlace> logPlace() {
        return logFolder.map(folder -> new LogPlace(folder.resolve(name + ".log"), logBytes));
    }

    /** The configuration of the boat's server for one start of it. */
    ServerConfig server(String bootId) {
        return conditions
                .describeTo(hull.describeTo(ServerConfig.of(name, bootId)))
                .lostLinkAction(lostLink)
                .build();
    }
}
