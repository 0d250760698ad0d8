package org.sami.crw.gui.picture;

import java.awt.Component;
import java.awt.Graphics;
import java.util.List;
import java.util.Optional;
import javax.swing.Icon;
import org.sami.palette.SemanticColor;
import org.sami.picture.photo.Photo;
import org.sami.ui.look.Look;

/** The first of some pictures in a line of a table; a frame while it is not here. */
public final class ThumbnailIcon implements Icon {
    private static final int WIDTH = 50;
    private static final int HEIGHT = 28;

    private final ShownPictures pictures;
    private final List<PictureChoice> some;

    private ThumbnailIcon(ShownPictures pictures, List<PictureChoice> some) {
        this.pictures = pictures;
        this.some = some;
    }

    /** The icon of some pictures; empty where there is none. */
    public static Optional<Icon> of(ShownPictures pictures, List<PictureChoice> some) {
        return some.isEmpty() ? Optional.empty() : Optional.of(new ThumbnailIcon(pictures, some));
    }

    @Override
    public void paintIcon(Component in, Graphics g, int x, int y) {
        some.stream()
                .flatMap(one -> one.picture().file().stream())
                .findFirst()
                .flatMap(file -> pictures.photo(file, getIconWidth(), getIconHeight()))
                .flatMap(Photo::image)
                .ifPresent(image -> g.drawImage(
                        image,
                        x + (getIconWidth() - image.getWidth()) / 2,
                        y + (getIconHeight() - image.getHeight()) / 2,
                        null));
        g.setColor(SemanticColor.BORDER.get());
        g.drawRect(x, y, getIconWidth() - 1, getIconHeight() - 1);
    }

    @Override
    public int getIconWidth() {
        return Look.px(WIDTH);
    }

    @Override
    public int getIconHeight() {
        return Look.px(HEIGHT);
    }
}
