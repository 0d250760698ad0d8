package org.sami.crw.proxy;

import java.util.Optional;

/** The waypoint lists that went to one boat: the latest, and how many there were. Tells the listener of every step. */
final class Uploads {
    private final String boatId;
    private final DeferredNotifications announcements;
    private Optional<Upload> latest = Optional.empty();
    private UploadCount count = UploadCount.NONE;

    Uploads(String boatId, DeferredNotifications announcements) {
        this.boatId = boatId;
        this.announcements = announcements;
    }

    /** The list that went to the boat last. */
    Optional<Upload> latest() {
        return latest;
    }

    UploadCount count() {
        return count;
    }

    /** The list that is on its way, or a new one, has come so far. */
    void reached(Upload upload) {
        latest = Optional.of(upload);
        count = count.oneMore(upload.state());
        announcements.add(l -> l.onUpload(boatId, upload));
    }

    /** Nobody waits any longer for what is on its way, if anything is. */
    void givenUp(String why) {
        latest.filter(upload -> !upload.state().isFinal())
                .ifPresent(upload -> reached(upload.failed(why.isEmpty() ? "it was given up" : why)));
    }
}
