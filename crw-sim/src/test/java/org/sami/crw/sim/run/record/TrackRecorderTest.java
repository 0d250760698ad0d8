package org.sami.crw.sim.run.record;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.sami.crw.report.BoatResult;
import org.sami.crw.report.LinkResult;
import org.sami.crw.report.TrackPoint;
import org.sami.crw.session.JoinOrder;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;

class TrackRecorderTest {
    private static final LinkResult LINK = new LinkResult("in-process", "b", 0, 0, LinkResult.Uploads.NONE, "");

    @Test
    void aBoatThatLayStillHasAPointAtTheMomentBeforeItMoved() {
        TrackRecorder recorder = new TrackRecorder();
        for (long t = 0; t <= 60_000; t += 1000) {
            recorder.look(t, List.of(boat("a", 0.0001 * t / 1000)));
        }
        List<TrackRecorder.Noted> noted = recorder.look(61_000, List.of(boat("a", 2)));

        assertThat(noted).extracting(TrackRecorder.Noted::atMillis).containsExactly(60_000L, 61_000L);
        assertThat(track(recorder, 61_000, boat("a", 2)))
                .extracting(TrackPoint::atMillis)
                .containsExactly(0L, 60_000L, 61_000L);
    }

    @Test
    void whatWasNotedDownComesBackAsTheSameTrack() {
        TrackRecorder recorder = new TrackRecorder();
        TrackRecorder again = new TrackRecorder();
        Random random = new Random(3);
        double east = 0;
        for (long t = 0; t <= 200_000; t += 1000) {
            east += random.nextInt(3) == 0 ? random.nextDouble() : 0;
            recorder.look(t, List.of(boat("a", east))).forEach(again::add);
        }

        assertThat(track(again, 200_000, boat("a", east))).isEqualTo(track(recorder, 200_000, boat("a", east)));
    }

    @Test
    void memoryDoesNotGrowWithTheLengthOfARun() {
        TrackRecorder recorder = new TrackRecorder(20_000);
        List<TrackPoint> truth = new ArrayList<>();
        long end = 100 * 3_600_000L;
        for (long t = 0; t <= end; t += 10_000) { // two boats on lanes of 200 m, for 100 hours
            BoatState lane = boat("lane", Math.abs((t / 10_000.0 * 15) % 400 - 200));
            recorder.look(t, List.of(lane, boat("other", t / 10_000.0)));
            truth.add(new TrackPoint(t, lane.eastM(), 0, 0, 0, 0, 0));
        }

        List<TrackPoint> kept =
                track(recorder, end, boat("lane", truth.get(truth.size() - 1).eastM()));
        assertThat(kept).hasSizeBetween(2700, 10_001);
        assertThat(kept)
                .extracting(TrackPoint::atMillis)
                .isSorted()
                .startsWith(0L)
                .endsWith(end);
        assertThat(recorder.notes(end))
                .singleElement()
                .satisfies(note -> assertThat(note.message())
                        .contains("of 2 of 2 boats")
                        .containsPattern("what is left is right to \\d\\.\\d\\d m"));
    }

    @Test
    void whoeverGoesAlongAThinnedTrackIsWithinTheToleranceAtEveryMoment() {
        Random random = new Random(5);
        List<TrackPoint> track = new ArrayList<>();
        double east = 0;
        double north = 0;
        for (int i = 0; i < 3000; i++) {
            east += 1 + 0.3 * random.nextGaussian();
            north += i / 500 % 2 == 0 ? 0.3 * random.nextGaussian() : 1;
            track.add(new TrackPoint(1000L * i, east, north, 0, 0, 0, 0));
        }

        List<TrackPoint> thinned = TrackThinning.within(2, track);

        assertThat(thinned).hasSizeLessThan(1500).startsWith(track.get(0)).endsWith(track.get(2999));
        for (TrackPoint point : track) {
            assertThat(distance(thinned, point)).isLessThanOrEqualTo(2);
        }
    }

    /** Views give marks by {@link JoinOrder}: a boat that the fleet lists first may have joined last. */
    @Test
    void aBoatHasTheMarkOfItsPlaceInTheOrderOfJoining() {
        TrackRecorder recorder = new TrackRecorder();
        for (String boat : List.of("bert", "anna")) {
            recorder.onStep(1, 0, new Input.ProxyJoined(boat), List.of(), null);
        }
        Effect starts = new Effect.MissionStarted(1, 0, "", "clv", "first", 1);
        recorder.onStep(2, 0, new Input.ProxyJoined("zoe"), List.of(starts), null);
        recorder.onStep(3, 0, new Input.ProxyJoined("abel"), List.of(), null);

        List<BoatState> fleet = List.of(boat("abel", 0), boat("anna", 0), boat("bert", 0), boat("zoe", 0));
        assertThat(recorder.results(0, fleet, id -> LINK))
                .extracting(BoatResult::mark)
                .containsExactly(3, 0, 1, 2);
    }

    private static double distance(List<TrackPoint> track, TrackPoint point) {
        for (int i = 0; i + 1 < track.size(); i++) {
            TrackPoint a = track.get(i);
            TrackPoint b = track.get(i + 1);
            if (a.atMillis() <= point.atMillis() && point.atMillis() <= b.atMillis()) {
                double part = (double) (point.atMillis() - a.atMillis()) / (b.atMillis() - a.atMillis());
                return Math.hypot(
                        a.eastM() + part * (b.eastM() - a.eastM()) - point.eastM(),
                        a.northM() + part * (b.northM() - a.northM()) - point.northM());
            }
        }
        return Double.NaN;
    }

    private static List<TrackPoint> track(TrackRecorder recorder, long now, BoatState boat) {
        return recorder.results(now, List.of(boat), id -> LINK).get(0).track();
    }

    private static BoatState boat(String id, double eastM) {
        return new BoatState(id, eastM, 0, 45, 10 + eastM * 1e-5, 1, 90, eastM, 0, 0);
    }
}
