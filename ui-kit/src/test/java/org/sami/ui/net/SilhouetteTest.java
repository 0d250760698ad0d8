package org.sami.ui.net;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.geom.Point2D;
import java.awt.image.BufferedImage;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.palette.Contrast;
import org.sami.palette.SemanticColor;
import org.sami.palette.Theme;
import org.sami.picture.net.NetMode;
import org.sami.ui.look.Look;

@Isolated("the look is one for all windows of a process")
class SilhouetteTest {
    @AfterEach
    void back() {
        Look.apply(Theme.LIGHT, 100);
    }

    /** In recovery mode with nothing selected they are all there is to be seen. */
    @ParameterizedTest
    @CsvSource({"LIGHT, 3", "DARK, 3", "SUN, 4.5"})
    void silhouettesStandOutFromTheCanvas(Theme theme, double least) {
        Look.apply(theme, 100);
        NetView view = NetScenes.view(NetScenes.plan("clv-interrupts"), 1200, 800);
        view.setMode(NetMode.RECOVERY);
        view.fit();

        BufferedImage image = NetScenes.paint(view);

        assertThat(view.scene().silhouettes()).hasSizeGreaterThan(10).allSatisfy(vertex -> {
            Point2D at = view.pixel(vertex.centre().x(), vertex.centre().y());
            Color seen = new Color(image.getRGB((int) at.getX(), (int) at.getY()));
            assertThat(Contrast.of(seen, SemanticColor.NET_CANVAS.get())).isGreaterThanOrEqualTo(least);
        });
    }
}
