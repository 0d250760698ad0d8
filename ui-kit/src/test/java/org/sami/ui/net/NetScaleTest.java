package org.sami.ui.net;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.geom.Point2D;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.palette.Theme;
import org.sami.spn.model.LayoutPoint;
import org.sami.ui.look.Look;

@Isolated("the look is one for all windows of a process")
class NetScaleTest {
    private final NetView view = NetScenes.view(NetScenes.plan("clv"), 1200, 800);

    @AfterEach
    void back() {
        Look.apply(Theme.LIGHT, 100);
    }

    @Test
    void aNetGrowsWithTheScaleOfTheLookWhileItIsOpen() {
        view.press(NetKey.ACTUAL_SIZE);
        LayoutPoint middle = view.centre();
        double before = pixelsOfAHundred();

        Look.apply(Theme.LIGHT, 150);
        view.doLayout();

        assertThat(pixelsOfAHundred()).isCloseTo(1.5 * before, within(0.01));
        assertThat(view.zoom()).isCloseTo(1, within(1e-9));
        assertThat(view.centre().x()).isCloseTo(middle.x(), within(0.01));
        assertThat(view.centre().y()).isCloseTo(middle.y(), within(0.01));
    }

    @Test
    void aNetOfWhichAllWasShownIsShownWholeAtAnotherScale() {
        NetView small = NetScenes.view(NetScenes.plan("clv"), 500, 320);
        double before = small.pixel(100, 0).distance(small.pixel(0, 0));

        Look.apply(Theme.LIGHT, 150);
        small.doLayout();

        assertThat(small.pixel(100, 0).distance(small.pixel(0, 0))).isCloseTo(before, within(0.01));
    }

    @ParameterizedTest
    @ValueSource(ints = {100, 150, 200})
    void wordsOfANetAreWrittenFromTheSameZoomOnAtEveryScale(int percent) {
        Look.apply(Theme.LIGHT, percent);
        view.setOverview(false); // its frame is blue, too
        view.doLayout();

        zoomTo(0.62);
        long written = lettersOfRequirements();
        zoomTo(0.58);
        assertThat(written).isGreaterThan(100 + 3 * lettersOfRequirements());
    }

    private double pixelsOfAHundred() {
        Point2D from = view.pixel(0, 0);
        return view.pixel(100, 0).distance(from);
    }

    private void zoomTo(double zoom) {
        view.press(NetKey.ACTUAL_SIZE);
        new NetSurface(view, viewport()).zoom(-Math.log(zoom) / Math.log(1.2), 600, 400);
        assertThat(view.zoom()).isCloseTo(zoom, within(1e-6));
    }

    private NetViewport viewport() {
        return new NetViewport((NetViewer) view.canvas(), () -> {});
    }

    /** Pixels in the colour of requirements, letters' soft rims included; nothing else of a net is blue. */
    private long lettersOfRequirements() {
        BufferedImage image = NetScenes.paint(view);
        return Arrays.stream(image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth()))
                .filter(rgb -> (rgb & 0xFF) - (rgb >> 16 & 0xFF) > 50)
                .count();
    }
}
