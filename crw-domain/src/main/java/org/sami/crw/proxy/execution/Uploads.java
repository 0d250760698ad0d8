package org.sami.crw.proxy.execution;

import java.util.Optional;
import org.sami.crw.fleet.DeferredEvents;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.command.Upload;
import org.sami.crw.proxy.command.UploadCount;

/** The waypoint lists that went to one boat: the latest, and how many there were. Tells the listener of every step. */
public final class Uploads {
    private final String boatId;
    private final DeferredEvents announcements;
    private Optional<Upload> latest = Optional.empty();
    private UploadCount count = UploadCount.NONE;

    Uploads(String boatId, DeferredEvents announcements) {
        this.boatId = boatId;
        this.announcements = announcements;
    }

    /** The list that went to the boat last. */
    public Optional<Upload> latest() {
        return latest;
    }

    /** How many paths have gone to the boat, and how far they came. */
    public UploadCount count() {
        return count;
    }

    /** The list that is on its way, or a new one, has come so far. */
    void reached(Upload upload) {
        latest = Optional.of(upload);
        count = count.oneMore(upload.state());
        announcements.add(new FleetEvent.UploadAdvanced(boatId, upload));
    }

    /** Nobody waits any longer for what is on its way, if anything is. */
    void givenUp(String why) {
        latest.filter(upload -> !upload.state().isFinal())
                .ifPresent(upload -> reached(upload.failed(why.isEmpty() ? "it was given up" : why)));
    }
}
