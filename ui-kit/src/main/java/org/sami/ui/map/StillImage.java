package org.sami.ui.map;

import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/**
 * What stays as it is while vehicles move, painted once in the pixels of the screen and kept. It is opaque: copying it costs a hundredth of
 * painting it.
 */
final class StillImage {
    private Optional<Key> kept = Optional.empty();
    private @Nullable BufferedImage image;

    private record Key(Object what, double scaleX, double scaleY, int width, int height) {}

    /**
     * Paints it from the upper left corner on.
     *
     * @param what all that it depends on; where it equals that of the last time, the kept image is painted
     * @param painter paints it when it has to be renewed
     */
    void paint(Graphics2D g, Object what, int width, int height, Consumer<Graphics2D> painter) {
        AffineTransform transform = g.getTransform();
        double scaleX = transform.getScaleX();
        double scaleY = transform.getScaleY();
        int deviceWidth = (int) Math.ceil(width * scaleX);
        int deviceHeight = (int) Math.ceil(height * scaleY);
        if (deviceWidth <= 0 || deviceHeight <= 0) {
            return;
        }
        Key key = new Key(Objects.requireNonNull(what, "what"), scaleX, scaleY, deviceWidth, deviceHeight);
        if (!kept.equals(Optional.of(key))) {
            if (image == null || image.getWidth() != deviceWidth || image.getHeight() != deviceHeight) {
                image = g.getDeviceConfiguration().createCompatibleImage(deviceWidth, deviceHeight);
            }
            Graphics2D own = image.createGraphics();
            own.scale(scaleX, scaleY);
            painter.accept(own);
            own.dispose();
            kept = Optional.of(key);
        }
        g.drawImage(image, AffineTransform.getScaleInstance(1 / scaleX, 1 / scaleY), null);
    }
}
