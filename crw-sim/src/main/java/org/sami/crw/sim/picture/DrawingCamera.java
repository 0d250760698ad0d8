package org.sami.crw.sim.picture;

import java.io.IOException;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.BiConsumer;
import java.util.function.Supplier;
import org.sami.boat.server.picture.PictureFolder;
import org.sami.boat.server.vehicle.Camera;
import org.sami.boat.server.vehicle.CameraShot;

/**
 * The camera of a simulated boat: it notes what is before it, and draws and keeps the picture on a thread of its own, which ends when there is nothing to do.
 * A picture that cannot be kept is reported, and the boat goes on.
 */
public final class DrawingCamera implements Camera, AutoCloseable {
    private static final int MOST_WAITING = 400;
    private static final int IDLE_S = 5;
    private static final int CLOSING_S = 10;

    private final PictureFolder folder;
    private final Supplier<Scene> ahead;
    private final BiConsumer<String, Exception> onFault;
    private final ThreadPoolExecutor drawing;

    /**
     * A camera that keeps its pictures in a folder.
     *
     * @param ahead what is before it now; asked on the thread that ticks the server
     * @param onFault gets in words, with the cause, why a picture is not kept; on any thread
     */
    public DrawingCamera(
            String boat, PictureFolder folder, Supplier<Scene> ahead, BiConsumer<String, Exception> onFault) {
        this.folder = folder;
        this.ahead = ahead;
        this.onFault = onFault;
        drawing = new ThreadPoolExecutor(
                1, 1, IDLE_S, TimeUnit.SECONDS, new LinkedBlockingQueue<>(MOST_WAITING), work -> {
                    Thread thread = new Thread(work, "camera-" + boat);
                    thread.setDaemon(true);
                    return thread;
                });
        drawing.allowCoreThreadTimeOut(true);
    }

    @Override
    public CameraShot take() {
        CameraShot shot = CameraShot.begun(folder.nextName());
        Scene scene = ahead.get();
        try {
            drawing.execute(() -> keep(shot, scene));
        } catch (RejectedExecutionException e) {
            shot.setFailed();
            onFault.accept("the picture " + shot.fileName() + " was not taken: too many wait to be kept", e);
        }
        return shot;
    }

    private void keep(CameraShot shot, Scene scene) {
        try {
            folder.keep(shot.fileName(), ScenePicture.jpeg(scene));
            shot.setKept();
        } catch (IOException | RuntimeException e) {
            shot.setFailed();
            onFault.accept("the picture " + shot.fileName() + " cannot be kept", e);
        }
    }

    /** Keeps the pictures that were taken, within ten seconds, and takes no more. */
    @Override
    public void close() {
        drawing.shutdown();
        try {
            if (!drawing.awaitTermination(CLOSING_S, TimeUnit.SECONDS)) {
                drawing.shutdownNow();
            }
        } catch (InterruptedException e) {
            drawing.shutdownNow();
            Thread.currentThread().interrupt();
        }
    }
}
