package org.sami.crw.mavlink;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.util.Optional;

/** Sets aside what this machine keeps of another vehicle that had the same system id. For the gateway's thread. */
final class ForeignFiles {
    private static final System.Logger LOG = System.getLogger(ForeignFiles.class.getName());

    private final String name;
    private final VehicleFiles files;
    private VehicleOwner owner;
    private Optional<String> news = Optional.empty();

    /**
     * Gives the files of a name to a vehicle.
     *
     * @param number of its autopilot; empty text where that is not known
     */
    ForeignFiles(String name, VehicleFiles files, String number, boolean flies) {
        this.name = name;
        this.files = files;
        owner = give(number, flies);
    }

    private VehicleOwner give(String number, boolean flies) {
        VehicleOwner asked = new VehicleOwner(number, flies, 0);
        Optional<VehicleOwner> before = files.owner(name);
        boolean isAnother = before.filter(asked::isAnother).isPresent();
        String stoppedBy = files.read(name).stoppedBy();
        try {
            VehicleOwner now = files.give(name, number, flies);
            if (isAnother) {
                news = Optional.of(words(before.get(), now, stoppedBy));
            }
            return now;
        } catch (IOException e) {
            LOG.log(Level.WARNING, "which vehicle has the files of " + name + " cannot be stored", e);
            if (isAnother) {
                news = Optional.of("what is kept of " + name + " is that of another vehicle and cannot be set aside: "
                        + e.getMessage());
            }
            return asked;
        }
    }

    private String words(VehicleOwner before, VehicleOwner now, String stoppedBy) {
        String what = before.flies() == now.flies()
                ? name + " is another " + KindWords.of(now) + " than the last one with its number"
                : name + " is a " + KindWords.of(now) + ", and the last one with its number was a "
                        + KindWords.of(before);
        String stopped = stoppedBy.isEmpty()
                ? ""
                : ", also that it was stopped by " + stoppedBy + ": this one is "
                        + (files.read(name).stoppedBy().isEmpty() ? "not stopped" : "stopped as well");
        return what + ": the list, the consumption and the fence of that one are kept for it" + stopped
                + ". Give each vehicle a system id of its own";
    }

    /** That what was kept was another vehicle's; empty where it was not. Told once. */
    Optional<String> news() {
        Optional<String> told = news;
        news = Optional.empty();
        return told;
    }

    /** What tells its starts from those of others that had its id. */
    String ofStarts() {
        return owner.vehicles() == 0 ? "" : " of vehicle " + (owner.vehicles() + 1);
    }

    /** Whether the files are not those of the vehicle with this number, which it has said late. */
    boolean isOfAnother(String number) {
        VehicleOwner said = new VehicleOwner(number, owner.flies(), 0);
        if (!number.isEmpty() && owner.number().isEmpty()) {
            owner = give(number, owner.flies());
        }
        return owner.isAnother(said);
    }
}
