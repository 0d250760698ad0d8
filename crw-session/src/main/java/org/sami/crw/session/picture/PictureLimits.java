package org.sami.crw.session.picture;

import java.util.Optional;
import org.sami.boat.link.KeptFile;

/**
 * Limits of what a session fetches of a boat's pictures.
 *
 * @param bytesOfOne most bytes of a picture
 * @param picturesOfBoat most pictures of a boat
 * @param bytesOfBoat most bytes of all pictures of a boat
 */
public record PictureLimits(long bytesOfOne, int picturesOfBoat, long bytesOfBoat) {
    /** 16 MiB each; 1,000 and 512 MiB of a boat. */
    public static final PictureLimits STANDARD = new PictureLimits(16L << 20, 1000, 512L << 20);

    /** Refuses bounds within which nothing fits. */
    public PictureLimits {
        if (bytesOfOne < 1 || picturesOfBoat < 1 || bytesOfBoat < 1) {
            throw new IllegalArgumentException(
                    "bounds of " + bytesOfOne + ", " + picturesOfBoat + " and " + bytesOfBoat);
        }
    }

    /** Why a picture is not fetched, in words; empty if it is. */
    Optional<String> whyNot(String boat, KeptFile picture, long bytesOfBoatBefore) {
        if (picture.bytes() > bytesOfOne) {
            return Optional.of(boat + ": the picture " + picture.name() + " has " + picture.bytes()
                    + " bytes, more than the " + bytesOfOne + " that a session takes; it stays on the boat");
        }
        if (bytesOfBoatBefore + picture.bytes() > bytesOfBoat) {
            return Optional.of(boat + ": the picture " + picture.name() + " stays on the boat, as all of its pictures"
                    + " would have more than the " + bytesOfBoat + " bytes that a session takes of a boat");
        }
        return Optional.empty();
    }

    /** Why a picture is not asked for, in words. */
    String tooMany(String boat, String name) {
        return boat + ": the picture " + name + " stays on the boat, as a session takes " + picturesOfBoat
                + " pictures of a boat at most";
    }
}
