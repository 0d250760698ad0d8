package org.sami.crw.operator.boat;

import java.util.Collection;
import org.sami.crw.proxy.status.LinkState;

/**
 * The one count of boats and their links, for every panel, the console and reports.
 *
 * @param linked boats with a link
 * @param lost boats whose link is lost
 * @param all all boats of the session, also those that have never answered
 */
public record FleetCount(int linked, int lost, int all) {
    /** That of boats, and of addresses at which none has answered. */
    public static FleetCount of(Collection<BoatSnapshot> boats, Collection<UnreachedBoat> unreached) {
        long nobody = unreached.stream()
                .filter(one -> boats.stream().noneMatch(boat -> boat.boat().equals(one.boat())))
                .count();
        return new FleetCount(
                count(boats, LinkState.LINKED), count(boats, LinkState.LOST), boats.size() + Math.toIntExact(nobody));
    }

    private static int count(Collection<BoatSnapshot> boats, LinkState link) {
        return Math.toIntExact(
                boats.stream().filter(boat -> boat.link() == link).count());
    }

    /** Such as {@code 3 of 4 boats}. */
    public String words() {
        return linked + " of " + all + (all == 1 ? " boat" : " boats");
    }

    /** Such as {@code 2 links lost}; empty text where none is. */
    public String lostWords() {
        return lost == 0 ? "" : lost + (lost == 1 ? " link lost" : " links lost");
    }
}
