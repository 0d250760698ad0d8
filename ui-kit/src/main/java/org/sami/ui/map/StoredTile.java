package org.sami.ui.map;

import java.awt.image.BufferedImage;
import java.util.Optional;
import org.jxmapviewer.viewer.Tile;

/** A tile that was read, is being read, or is not there; on the event thread. */
final class StoredTile extends Tile {
    private BufferedImage image;
    private boolean answered;

    StoredTile(int x, int y, int zoom) {
        super(x, y, zoom);
    }

    synchronized void answer(Optional<BufferedImage> image) {
        this.image = image.orElse(null);
        answered = true;
    }

    /** Whether it is known that there is no such tile. */
    synchronized boolean isMissing() {
        return answered && image == null;
    }

    @Override
    public synchronized boolean isLoaded() {
        return image != null;
    }

    @Override
    public BufferedImage getImage() {
        return image;
    }
}
