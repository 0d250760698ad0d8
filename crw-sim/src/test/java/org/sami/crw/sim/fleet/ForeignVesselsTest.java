package org.sami.crw.sim.fleet;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.crw.service.water.Water;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.vessel.ForeignVessel;
import org.sami.crw.sim.vessel.ForeignVessel.TrackPlace;
import org.sami.crw.sim.vessel.ForeignVessels;
import org.sami.crw.sim.vessel.VesselState;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoArea;

/** Whether a boat gives way to a vessel that it sees: measured on where both truly are. */
class ForeignVesselsTest {
    private static ForeignVessels one(double lengthM, double beamM, double... secondsEastNorth) {
        List<TrackPlace> track = new ArrayList<>();
        for (int i = 0; i < secondsEastNorth.length; i += 3) {
            track.add(new TrackPlace(secondsEastNorth[i], secondsEastNorth[i + 1], secondsEastNorth[i + 2]));
        }
        return new ForeignVessels(List.of(new ForeignVessel("ferry", lengthM, beamM, track, false)), 60);
    }

    /** The least distance of the boat, which drives 200 m to the east, to the vessel's hull. */
    private static double nearestM(ForeignVessels vessels, Optional<Rock> rock, long seconds) {
        SimulatedTestWorld world = new SimulatedTestWorld(1, 1, FleetConfig.DEFAULT.withVessels(vessels));
        world.run(1);
        FollowPath open = world.path("way", 1, Priority.MEDIUM, 200, 0);
        FollowPath path = rock.map(
                        one -> open.in(Water.of(world.boat().position(), List.of(one.area(world)), Optional.empty())
                                .drivenWith(CrossTrackError.CALM)))
                .orElse(open);
        world.proxy().commands().submit(path);
        double nearestM = Double.POSITIVE_INFINITY;
        for (double t = 0; t < seconds && !world.reports().contains("completed way"); t += 0.2) {
            world.run(0.2);
            VesselState vessel =
                    vessels.at(world.clock.nowMs() / 1000.0, Conditions.CALM).get(0);
            nearestM = Math.min(
                    nearestM,
                    vessel.distanceM(world.hull().eastM(), world.hull().northM()));
            rock.ifPresent(one -> assertThat(
                            one.depthM(world.hull().eastM(), world.hull().northM()))
                    .isZero());
        }
        assertThat(world.reports()).contains("completed way");
        return nearestM;
    }

    /** A box on the boat's plane. */
    private record Rock(double westM, double southM, double eastM, double northM) {
        GeoArea area(SimulatedTestWorld world) {
            return new GeoArea(world.points(westM, southM, eastM, southM, eastM, northM, westM, northM), List.of());
        }

        double depthM(double atEastM, double atNorthM) {
            return Math.max(
                    0,
                    Math.min(
                            Math.min(atEastM - westM, eastM - atEastM),
                            Math.min(atNorthM - southM, northM - atNorthM)));
        }
    }

    @ParameterizedTest
    @CsvSource({
        "12, 4, '0,200,0, 130,-60,0'", // head on
        "12, 4, '0,100,-134, 134,100,134'", // across, at 2 m/s
        "6, 2, '0,100,210, 140,100,-210'", // across, at 3 m/s
        "30, 8, '0,100,-70, 280,100,70'", // across, large and slow
        "8, 3, '0,60,0, 400,300,0'", // ahead, slower
        "2, 1, '0,100,0'", // at rest on the line
        "20, 5, '0,90,-80, 100,110,20'"
    })
    void boatGivesWayToAVesselThatItSees(double lengthM, double beamM, String track) {
        double[] numbers = Arrays.stream(track.split(","))
                .mapToDouble(text -> Double.parseDouble(text.strip()))
                .toArray();

        double nearestM = nearestM(one(lengthM, beamM, numbers), Optional.empty(), 900);

        assertThat(nearestM).isGreaterThan(3);
    }

    @Test
    void boatThatGivesWayToAVesselStaysOutsideNoGoAreas() {
        double nearestM = nearestM(one(6, 2, 0, 200, 0, 130, -60, 0), Optional.of(new Rock(20, 1, 180, 40)), 900);

        assertThat(nearestM).isGreaterThan(3);
    }

    /** Vessels that go straight on, so that they would meet the boat on its line if it did not give way. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4})
    void boatGivesWayToVesselsFromAnySide(int seed) {
        Random random = new Random(seed);
        for (int i = 0; i < 15; i++) {
            double lengthM = 2 + 18 * random.nextDouble();
            double mps = 0.5 + 2.5 * random.nextDouble();
            double course = 2 * Math.PI * random.nextDouble();
            double meetsS = 40 + 50 * random.nextDouble();
            double atM = 1.5 * meetsS + 10 * random.nextDouble() - 5;
            double east = Math.sin(course) * mps;
            double north = Math.cos(course) * mps;
            ForeignVessels vessels = one(
                    lengthM,
                    lengthM / 3,
                    0,
                    atM - meetsS * east,
                    -meetsS * north,
                    meetsS + 400,
                    atM + 400 * east,
                    400 * north);

            if (vessels.at(0, Conditions.CALM).get(0).distanceM(0, 0) > 30) { // it does not begin beside the boat
                assertThat(nearestM(vessels, Optional.empty(), 900))
                        .as("%s: %.0f m long, %.1f m/s", i, lengthM, mps)
                        .isGreaterThan(3);
            }
        }
    }
}
