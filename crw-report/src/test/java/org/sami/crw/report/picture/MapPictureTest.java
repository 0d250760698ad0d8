package org.sami.crw.report.picture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Point2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Random;
import java.util.Set;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.sami.crw.report.ClosestApproach;
import org.sami.crw.report.Exploration;
import org.sami.crw.report.LocationResult;
import org.sami.crw.report.MapArea;
import org.sami.crw.report.MapPoint;
import org.sami.crw.report.RunHeader;
import org.sami.crw.report.RunMap;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.report.RunResult;
import org.sami.crw.report.SampleReport;

class MapPictureTest {
    private static final Rectangle FRAME = new Rectangle(100, 100, 900, 900);
    private static final RunReport SAMPLE = SampleReport.of(3, 12);

    @Test
    void theScaleIsThatOfWhatHappenedAndNotOfTheArea() {
        MapScale small = MapScale.fitting(report(600, RunOutcome.ENDED, "", RunMap.of(List.of())), FRAME);
        MapScale large = MapScale.fitting(report(20_000, RunOutcome.ENDED, "", RunMap.of(List.of())), FRAME);

        assertThat(large.pixels(1)).isEqualTo(small.pixels(1)).isGreaterThan(1);
        for (LocationResult location : SAMPLE.locations()) {
            assertThat(FRAME.contains(large.at(location.eastM(), location.northM())))
                    .isTrue();
        }
    }

    @Test
    void anAreaThatNobodyWentToIsOnTheMapAllTheSame() {
        MapArea far = area(MapArea.Kind.EXPLORED, 3000);

        MapScale scale = MapScale.fitting(
                report(600, RunOutcome.ENDED, "", new RunMap(List.of(far), List.of(), List.of(), nothingNear())),
                FRAME);

        assertThat(far.outline()).allMatch(p -> FRAME.contains(scale.at(p.eastM(), p.northM())));
    }

    @Test
    void areasThatWereExploredAvoidedAndLeftUncoveredAreDrawn() throws Exception {
        RunMap map = new RunMap(
                List.of(area(MapArea.Kind.EXPLORED, 0), area(MapArea.Kind.AVOIDED, 150)),
                List.of(),
                List.of(new Exploration(
                        0,
                        10,
                        100,
                        new Exploration.Left(Optional.empty(), Optional.of(50.0), Optional.empty()),
                        List.of(area(MapArea.Kind.UNCOVERED, -150)))),
                nothingNear());

        Set<Integer> without = colors(report(600, RunOutcome.ENDED, "", RunMap.of(List.of())));
        Set<Integer> with = colors(report(600, RunOutcome.ENDED, "", map));

        for (MapArea.Kind kind : List.of(MapArea.Kind.AVOIDED, MapArea.Kind.UNCOVERED, MapArea.Kind.EXPLORED)) {
            assertThat(nearest(with, MapColors.area(kind)))
                    .as(kind.words())
                    .isLessThan(nearest(without, MapColors.area(kind)));
            assertThat(nearest(with, MapColors.area(kind))).as(kind.words()).isLessThan(60);
        }
    }

    /** How near the nearest of the colours is, in steps of the three channels together. */
    private static int nearest(Set<Integer> colors, Color wanted) {
        return colors.stream()
                .map(Color::new)
                .mapToInt(c -> Math.abs(c.getRed() - wanted.getRed())
                        + Math.abs(c.getGreen() - wanted.getGreen())
                        + Math.abs(c.getBlue() - wanted.getBlue()))
                .min()
                .orElseThrow();
    }

    @Test
    void whyARunFailedStandsAboveTheMap() throws Exception {
        int fault = MapColors.FAULT.getRGB() & 0xFFFFFF;
        RunMap map = RunMap.of(List.of());

        assertThat(colors(report(600, RunOutcome.FAILED, "nobody answers: Choose boats", map)))
                .contains(fault);
        assertThat(colors(report(600, RunOutcome.ENDED, "", map))).doesNotContain(fault);
    }

    @Test
    void numbersOfLocationsDoNotCoverEachOther() {
        LabelSpace labels = new LabelSpace(FRAME);
        Random random = new Random(2);
        List<Point2D> discs = new ArrayList<>();
        for (int i = 0; i < 40; i++) {
            Point2D wanted = new Point2D.Double(500 + 60 * random.nextGaussian(), 500 + 60 * random.nextGaussian());
            discs.add(labels.disc(wanted, 12));
        }

        for (int i = 0; i < discs.size(); i++) {
            for (int j = i + 1; j < discs.size(); j++) {
                assertThat(discs.get(i).distance(discs.get(j))).isGreaterThanOrEqualTo(24);
            }
        }
        assertThat(discs).allMatch(FRAME::contains);
    }

    @Test
    void aBoatStandsAheadOfTheLocationOnWhichItEnds() {
        LabelSpace labels = new LabelSpace(FRAME);
        Point2D location = labels.disc(new Point2D.Double(500, 500), 12);

        Point2D boat = labels.ahead(new Point2D.Double(495, 500), 12, Math.PI / 2);

        assertThat(boat.getY()).isCloseTo(500, within(1e-9));
        assertThat(boat.getX()).isBetween(525.0, 528.0);
        assertThat(location).isEqualTo(new Point2D.Double(500, 500));
    }

    @Test
    void textKeepsToItsWidth() {
        FontMetrics metrics = metrics();
        String words = "It waits for ProxyPathCompleted, which has not been received, ".repeat(20);

        List<String> lines = DrawnText.lines(words, metrics, 400, 3);

        assertThat(lines).hasSize(3).allMatch(line -> metrics.stringWidth(line) <= 400);
        assertThat(lines.get(2)).endsWith("\u2026");
        assertThat(DrawnText.fitting("x".repeat(500), metrics, 400))
                .endsWith("\u2026")
                .matches(line -> metrics.stringWidth(line) <= 400);
        assertThat(DrawnText.lines("short", metrics, 400, 3)).containsExactly("short");
        assertThat(DrawnText.lines("", metrics, 400, 3)).isEmpty();
    }

    private static FontMetrics metrics() {
        Graphics2D g = new BufferedImage(8, 8, BufferedImage.TYPE_INT_RGB).createGraphics();
        return g.getFontMetrics(DrawnText.font(Font.PLAIN, 15));
    }

    private static Set<Integer> colors(RunReport report) throws Exception {
        BufferedImage picture = ImageIO.read(new ByteArrayInputStream(new MapPicture(report).png()));
        Set<Integer> colors = new HashSet<>();
        for (int x = 0; x < 1060; x++) {
            for (int y = 0; y < picture.getHeight(); y++) {
                colors.add(picture.getRGB(x, y) & 0xFFFFFF);
            }
        }
        return colors;
    }

    private static ClosestApproach nothingNear() {
        return new ClosestApproach(Optional.empty(), Optional.empty(), List.of(), 0);
    }

    private static MapArea area(MapArea.Kind kind, double eastM) {
        return new MapArea(
                kind,
                List.of(point(eastM, 0), point(eastM + 100, 0), point(eastM + 100, 80), point(eastM, 80)),
                List.of());
    }

    private static MapPoint point(double eastM, double northM) {
        return new MapPoint(40 + northM / 111_000, -80 + eastM / 85_000, eastM, northM);
    }

    private static RunReport report(double areaM, RunOutcome outcome, String reason, RunMap map) {
        RunHeader header = SAMPLE.header();
        return new RunReport(
                        new RunHeader(
                                header.plan(),
                                header.planName(),
                                header.planHash(),
                                header.mission(),
                                header.seed(),
                                header.speed(),
                                areaM,
                                header.place()),
                        new RunResult(outcome, reason, 754_300, 1.25, 19, 23, OptionalLong.empty(), "ab".repeat(32)),
                        SAMPLE.boats(),
                        SAMPLE.locations(),
                        List.of(),
                        List.of(),
                        List.of(),
                        List.of())
                .withMap(map);
    }
}
