package org.sami.picture.photo;

import java.awt.image.BufferedImage;
import java.util.Objects;
import java.util.Optional;

/**
 * A decoded picture file, or the reason why it cannot be shown.
 *
 * @param image the picture, perhaps with fewer pixels than the file has; empty if it cannot be shown. Must not be changed
 * @param problem why it cannot be shown, in words; empty where it can
 * @param widthPx of the picture in the file; 0 where it is not known
 * @param heightPx of the picture in the file; 0 where it is not known
 */
public record Photo(Optional<BufferedImage> image, String problem, int widthPx, int heightPx) {
    public Photo {
        Objects.requireNonNull(image, "image");
        Objects.requireNonNull(problem, "problem");
    }

    static Photo of(BufferedImage image, int widthPx, int heightPx) {
        return new Photo(Optional.of(image), "", widthPx, heightPx);
    }

    /** A picture that cannot be shown, for a reason in words. */
    public static Photo none(String problem) {
        return new Photo(Optional.empty(), problem, 0, 0);
    }
}
