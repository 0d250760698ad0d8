package org.sami.crw.report.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.report.DepthsPart;
import org.sami.crw.report.DepthsPart.DepthCell;
import org.sami.crw.report.DepthsPart.MapError;
import org.sami.crw.report.MapPoint;
import org.sami.crw.report.ReportPart;
import org.sami.crw.report.RunReport;
import org.sami.crw.report.SampleReport;
import org.sami.crw.report.file.ReportFolder;

/** The map of measured depths, and its files. */
class DepthPictureTest {
    private static final RunReport SAMPLE = SampleReport.of(3, 12);
    private static final int ROW_PX = 104 + 390; // the middle of the map

    @TempDir
    private Path folder;

    /** One row of squares, each a metre deeper than the one west of it. */
    private static DepthsPart slope(int squares) {
        List<DepthCell> cells = new ArrayList<>();
        for (int i = 0; i < squares; i++) {
            cells.add(new DepthCell(new MapPoint(45.7, 10.72, i * 5.0, 0), 0.5 + i, 2));
        }
        return new DepthsPart(5, 2L * squares, cells, Optional.of(new MapError(squares, 0.1, 0.25)));
    }

    private static BufferedImage drawn(DepthsPart depths) throws Exception {
        return ImageIO.read(new ByteArrayInputStream(new DepthPicture(SAMPLE, depths).png()));
    }

    private static RunReport with(ReportPart... parts) {
        RunReport sample = SampleReport.of(2, 3);
        return new RunReport(
                sample.header(),
                sample.result(),
                sample.boats(),
                sample.locations(),
                sample.decisions(),
                sample.firings(),
                sample.interrupts(),
                sample.notes(),
                sample.readings(),
                sample.tasks(),
                sample.waits(),
                sample.origin(),
                sample.map(),
                List.of(parts));
    }

    private static int brightness(int rgb) {
        Color color = new Color(rgb);
        return color.getRed() + color.getGreen() + color.getBlue();
    }

    @Test
    void deeperWaterIsDarker() throws Exception {
        BufferedImage picture = drawn(slope(8));

        int west = brightness(picture.getRGB(104 + 80, ROW_PX));
        int middle = brightness(picture.getRGB(104 + 430, ROW_PX));
        int east = brightness(picture.getRGB(104 + 770, ROW_PX));
        assertThat(west).isGreaterThan(middle + 100);
        assertThat(middle).isGreaterThan(east + 100);
    }

    @Test
    void aFlatBottomAndADeepSeaCanBeDrawn() throws Exception {
        DepthCell flat = new DepthCell(new MapPoint(45.7, 10.72, 0, 0), 3, 1);
        DepthCell deep = new DepthCell(new MapPoint(45.7, 10.72, 5, 0), 9000, 1);

        assertThat(drawn(new DepthsPart(5, 1, List.of(flat), Optional.empty()))).isNotNull();
        assertThat(drawn(new DepthsPart(5, 2, List.of(flat, deep), Optional.empty())))
                .isNotNull();
    }

    @Test
    void aReportWithDepthsHasTheirMapAndTable() throws Exception {
        new ReportFolder(folder).write(with(slope(3)));

        assertThat(folder.resolve("depths.png")).isNotEmptyFile();
        assertThat(Files.readAllLines(folder.resolve("depths.csv")))
                .hasSize(4)
                .first()
                .isEqualTo("lat_deg,lon_deg,east_m,north_m,depth_m,readings");
        assertThat(Files.readString(folder.resolve("report.json"))).contains("\"errorP95M\"");
    }

    @Test
    void theTextSaysDepthsAndError() {
        assertThat(slope(3).lines())
                .containsExactly(
                        "depths      0.5 to 2.5 m in 3 squares of 5 m, from 6 readings",
                        "  error     mean 0.10 m, 95 of 100 squares within 0.25 m of the true depth at their middle");
    }
}
