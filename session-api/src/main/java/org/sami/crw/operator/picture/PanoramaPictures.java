package org.sami.crw.operator.picture;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.crw.markup.MapRelevance;
import org.sami.spn.value.GeoPoint;

/**
 * The pictures that a boat took for one command. Immutable.
 *
 * @param panorama id of the command
 * @param mission whose command it was
 * @param atMillis when the boat reported them, on the session's clock
 * @param from where the boat was
 * @param pictures in the order in which they were taken; at least one
 */
public record PanoramaPictures(
        String boat, String panorama, long mission, long atMillis, GeoPoint from, List<BoatPicture> pictures) {
    public PanoramaPictures {
        Objects.requireNonNull(boat, "boat");
        Objects.requireNonNull(panorama, "panorama");
        Objects.requireNonNull(from, "from");
        pictures = List.copyOf(pictures);
    }

    /** How many are here. */
    public int here() {
        return (int) pictures.stream().filter(one -> one.file().isPresent()).count();
    }

    /** How many may still come. */
    public int coming() {
        return (int) pictures.stream().filter(BoatPicture::isComing).count();
    }

    /** How many there are, how many are here and why others are not, in a line. */
    public String words() {
        int missed = pictures.size() - here() - coming();
        String coming = coming() == 0 ? "" : ", " + coming() + " not here yet";
        String lost = missed == 0 ? "" : ", " + missed + " will not come";
        return boat + ": " + here() + " of " + pictures.size() + " pictures" + coming + lost;
    }

    /** The same with another state of a picture; the same where it has none of that name. */
    public PanoramaPictures with(BoatPicture changed) {
        List<BoatPicture> all = new ArrayList<>(pictures);
        all.replaceAll(one -> one.name().equals(changed.name()) ? changed : one);
        return new PanoramaPictures(boat, panorama, mission, atMillis, from, all);
    }

    /**
     * The pictures that a message or a decision shows (markup Relevant Proxy, option showPictures): of each of its boats those that it had taken last when the message or the
     * decision came.
     *
     * @param all that there are, the oldest first
     * @param atMillis when the message or the decision came
     */
    public static List<PanoramaPictures> shownWith(List<PanoramaPictures> all, MapRelevance map, long atMillis) {
        List<PanoramaPictures> shown = new ArrayList<>();
        for (String boat : map.boats()
                .filter(MapRelevance.Boats::showPictures)
                .map(MapRelevance.Boats::boats)
                .orElse(List.of())) {
            last(all, boat, atMillis).ifPresent(shown::add);
        }
        return shown;
    }

    private static Optional<PanoramaPictures> last(List<PanoramaPictures> all, String boat, long atMillis) {
        return all.stream()
                .filter(one -> one.boat().equals(boat) && one.atMillis() <= atMillis)
                .reduce((earlier, later) -> later);
    }
}
