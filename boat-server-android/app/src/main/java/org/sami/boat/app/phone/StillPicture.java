package org.sami.boat.app.phone;

import android.annotation.SuppressLint;
import android.graphics.ImageFormat;
import android.hardware.camera2.CameraAccessException;
import android.hardware.camera2.CameraCaptureSession;
import android.hardware.camera2.CameraDevice;
import android.hardware.camera2.CameraManager;
import android.hardware.camera2.CaptureRequest;
import android.media.Image;
import android.media.ImageReader;
import android.os.Handler;
import android.os.HandlerThread;
import android.util.Size;
import android.view.Surface;
import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Collections;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * One opening of a camera, for one picture: open, let the exposure settle over some frames, take the next one. Every wait has a limit. The phone answers on a
 * thread of this opening, which ends with {@link #close}.
 */
final class StillPicture implements Closeable {
    private static final long WITHIN_S = 5;
    private static final int SETTLING_FRAMES = 10; // the first frames of an opened camera are too dark

    private final CameraManager cameras;
    private final String id;
    private final HandlerThread thread = new HandlerThread("boat-camera-answers");
    private final Handler answers;
    private final ImageReader reader;
    private final CompletableFuture<CameraDevice> opened = new CompletableFuture<>();
    private final CompletableFuture<CameraCaptureSession> configured = new CompletableFuture<>();
    private final CompletableFuture<Image> taken = new CompletableFuture<>();
    private int frames; // for the thread of the answers

    StillPicture(CameraManager cameras, String id, Size size) {
        this.cameras = cameras;
        this.id = id;
        reader = ImageReader.newInstance(size.getWidth(), size.getHeight(), ImageFormat.JPEG, 2);
        thread.start();
        answers = new Handler(thread.getLooper());
        reader.setOnImageAvailableListener(this::arrived, answers);
    }

    /** Takes the picture; once only. */
    @SuppressLint("MissingPermission") // whoever lacks it gets the exception that the caller puts into words
    byte[] take(int mostBytes) throws IOException, CameraAccessException, InterruptedException {
        cameras.openCamera(id, new Opening(), answers);
        CameraDevice camera = await(opened, "the camera does not open");
        Surface surface = reader.getSurface();
        camera.createCaptureSession(Collections.singletonList(surface), new Configuring(), answers);
        CameraCaptureSession session = await(configured, "the camera does not begin");
        CaptureRequest.Builder request = camera.createCaptureRequest(CameraDevice.TEMPLATE_STILL_CAPTURE);
        request.addTarget(surface);
        session.setRepeatingRequest(request.build(), null, answers);
        try (Image image = await(taken, "the camera gives no picture")) {
            return bytes(image.getPlanes()[0].getBuffer(), mostBytes);
        }
    }

    /** What a picture consists of, unless it is too large; nothing is copied then. */
    static byte[] bytes(ByteBuffer picture, int mostBytes) throws IOException {
        if (picture.remaining() > mostBytes) {
            throw new IOException("it has " + picture.remaining() + " bytes, more than " + mostBytes);
        }
        byte[] bytes = new byte[picture.remaining()];
        picture.get(bytes);
        return bytes;
    }

    private void arrived(ImageReader from) {
        Image image = from.acquireNextImage();
        if (image == null) {
            return;
        }
        frames++;
        if (frames <= SETTLING_FRAMES || !taken.complete(image)) {
            image.close();
        }
    }

    private static <T> T await(CompletableFuture<T> answer, String what) throws IOException, InterruptedException {
        try {
            return answer.get(WITHIN_S, TimeUnit.SECONDS);
        } catch (TimeoutException e) {
            throw new IOException(what + " within " + WITHIN_S + " s", e);
        } catch (ExecutionException e) {
            Throwable cause = e.getCause();
            throw new IOException(what + ": " + (cause == null ? e : cause).getMessage(), e);
        }
    }

    @Override
    public void close() {
        boolean never = opened.completeExceptionally(new IOException("the camera opened too late"));
        if (!never && !opened.isCompletedExceptionally()) {
            opened.join().close();
        }
        reader.close();
        thread.quitSafely();
    }

    /** Ends all waits for a reason. */
    private void failed(String why) {
        IOException fault = new IOException(why);
        opened.completeExceptionally(fault);
        configured.completeExceptionally(fault);
        taken.completeExceptionally(fault);
    }

    /** How the opening goes. */
    private final class Opening extends CameraDevice.StateCallback {
        @Override
        public void onOpened(CameraDevice camera) {
            if (!opened.complete(camera)) {
                camera.close();
            }
        }

        @Override
        public void onDisconnected(CameraDevice camera) {
            camera.close();
            failed("another app has taken it, or the phone keeps it from apps in the background");
        }

        @Override
        public void onError(CameraDevice camera, int error) {
            camera.close();
            failed("error " + error + " of the phone");
        }
    }

    /** How its beginning goes. */
    private final class Configuring extends CameraCaptureSession.StateCallback {
        @Override
        public void onConfigured(CameraCaptureSession session) {
            configured.complete(session);
        }

        @Override
        public void onConfigureFailed(CameraCaptureSession session) {
            failed("the phone cannot set it up for pictures");
        }
    }
}
