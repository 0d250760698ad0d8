package org.sami.ui.map;

import java.awt.image.BufferedImage;
import java.util.Optional;
import org.sami.ui.map.base.BaseStyle;
import org.sami.ui.map.base.TileKey;

/** A tile that was read, is being read, or is not there; on the event thread. */
final class StoredTile {
    private final TileKey key;
    private final BaseStyle style;
    private Optional<BufferedImage> image = Optional.empty();
    private boolean answered;
    private long used;

    StoredTile(TileKey key, BaseStyle style) {
        this.key = key;
        this.style = style;
    }

    TileKey key() {
        return key;
    }

    BaseStyle style() {
        return style;
    }

    void answer(Optional<BufferedImage> image) {
        this.image = image;
        answered = true;
    }

    /** Whether it came, with a picture or without one. */
    boolean isAnswered() {
        return answered;
    }

    /** Its picture; none where there is none, or where it has not come yet. */
    Optional<BufferedImage> image() {
        return image;
    }

    /** How much memory it takes. */
    long bytes() {
        return image.map(one -> 4L * one.getWidth() * one.getHeight()).orElse(0L);
    }

    /** It was looked at in that painting. */
    void use(long painting) {
        used = painting;
    }

    /** The painting in which it was looked at last. */
    long used() {
        return used;
    }
}
