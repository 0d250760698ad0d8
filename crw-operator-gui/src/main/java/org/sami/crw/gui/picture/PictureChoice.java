package org.sami.crw.gui.picture;

import java.util.ArrayList;
import java.util.List;
import org.sami.crw.operator.picture.BoatPicture;
import org.sami.crw.operator.picture.PanoramaPictures;

/**
 * One picture of a panorama. Immutable.
 *
 * @param of the panorama
 * @param index from 0
 */
public record PictureChoice(PanoramaPictures of, int index) {
    /** Refuses a picture that there is not. */
    public PictureChoice {
        of.pictures().get(index);
    }

    static List<PictureChoice> of(PanoramaPictures all) {
        List<PictureChoice> each = new ArrayList<>();
        for (int index = 0; index < all.pictures().size(); index++) {
            each.add(new PictureChoice(all, index));
        }
        return each;
    }

    BoatPicture picture() {
        return of.pictures().get(index);
    }

    /** Whether both are the same picture, here or not. */
    boolean isSame(PictureChoice other) {
        return index == other.index
                && of.boat().equals(other.of.boat())
                && of.panorama().equals(other.of.panorama());
    }

    /** Which boat's and which of how many. */
    String words() {
        return of.boat() + ", picture " + (index + 1) + " of " + of.pictures().size();
    }
}
