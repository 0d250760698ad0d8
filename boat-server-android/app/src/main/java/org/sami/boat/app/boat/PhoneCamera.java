package org.sami.boat.app.boat;

import java.io.Closeable;
import java.io.IOException;
import java.util.Objects;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import org.sami.boat.server.picture.PictureFolder;
import org.sami.boat.server.vehicle.Camera;
import org.sami.boat.server.vehicle.CameraShot;

/**
 * The camera of a boat on a phone: pictures are taken and kept in their folder one after another, on a thread of its own, which ends when there is nothing to do.
 * A picture that fails is said, and the boat goes on. Safe for use by several threads.
 */
final class PhoneCamera implements Camera, Closeable {
    private static final int MOST_WAITING =
            16; // they show what is ahead when their turn comes, so a long queue is worth nothing
    private static final int IDLE_S = 5;

    private final PictureSource source;
    private final PictureFolder folder;
    private final PhoneNews news;
    private final ThreadPoolExecutor taking;
    private volatile String failure = "";

    PhoneCamera(PictureSource source, PictureFolder folder, PhoneNews news) {
        this.source = Objects.requireNonNull(source, "source");
        this.folder = Objects.requireNonNull(folder, "folder");
        this.news = Objects.requireNonNull(news, "news");
        taking = new ThreadPoolExecutor(
                1, 1, IDLE_S, TimeUnit.SECONDS, new LinkedBlockingQueue<>(MOST_WAITING), work -> {
                    Thread thread = new Thread(work, "boat-camera");
                    thread.setDaemon(true);
                    return thread;
                });
        taking.allowCoreThreadTimeOut(true);
    }

    /** Why no picture can be taken, in words; empty text if one can. */
    String trouble() {
        return source.trouble();
    }

    /** Why the last picture failed, in words; empty text if it did not. */
    String failure() {
        return failure;
    }

    @Override
    public CameraShot take() {
        CameraShot shot = CameraShot.begun(folder.nextName());
        try {
            taking.execute(() -> take(shot));
        } catch (RejectedExecutionException e) {
            failed(shot, "too many pictures wait to be taken");
        }
        return shot;
    }

    private void take(CameraShot shot) {
        try {
            folder.keep(shot.fileName(), source.take(PictureFolder.MOST_BYTES_OF_ONE));
            failure = "";
            shot.setKept();
        } catch (IOException | RuntimeException e) { // a phone's camera fails in its own ways; the boat goes on
            failed(shot, String.valueOf(e.getMessage()));
        }
    }

    private void failed(CameraShot shot, String why) {
        failure = why;
        news.said("the picture " + shot.fileName() + " was not taken: " + why);
        shot.setFailed();
    }

    /** Takes no more pictures. */
    @Override
    public void close() {
        taking.shutdownNow();
    }
}
