package org.sami.boat.app.phone;

import android.Manifest;
import android.content.Context;
import android.content.pm.PackageManager;
import android.graphics.ImageFormat;
import android.hardware.camera2.CameraAccessException;
import android.hardware.camera2.CameraCharacteristics;
import android.hardware.camera2.CameraManager;
import android.hardware.camera2.params.StreamConfigurationMap;
import android.util.Size;
import java.io.IOException;
import java.util.Arrays;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sami.boat.app.boat.PictureSource;

/**
 * The camera that looks out of the back of the phone; where there is none, the first that there is. It is opened for each picture and closed after it, as an
 * open camera heats the phone.
 */
public final class BackCamera implements PictureSource {
    private static final int LONGEST_SIDE = 1600;

    private final Context context;
    private final @Nullable CameraManager cameras;

    /** The camera of a phone, which is not touched before a picture is taken. */
    public BackCamera(Context context) {
        this.context = context;
        cameras = (CameraManager) context.getSystemService(Context.CAMERA_SERVICE);
    }

    @Override
    public String trouble() {
        if (!context.getPackageManager().hasSystemFeature(PackageManager.FEATURE_CAMERA_ANY)) {
            return "the phone has no camera";
        }
        if (context.checkSelfPermission(Manifest.permission.CAMERA) != PackageManager.PERMISSION_GRANTED) {
            return "the phone does not let the app use its camera: allow it in the phone's settings of this app";
        }
        return "";
    }

    @Override
    public byte[] take(int mostBytes) throws IOException {
        String trouble = trouble();
        if (!trouble.isEmpty()) {
            throw new IOException(trouble);
        }
        try {
            CameraManager manager = cameras;
            Optional<String> camera = manager == null ? Optional.empty() : choose(manager);
            if (manager == null || !camera.isPresent()) {
                throw new IOException("the phone has no camera");
            }
            Size size = size(manager.getCameraCharacteristics(camera.get()));
            try (StillPicture picture = new StillPicture(manager, camera.get(), size)) {
                return picture.take(mostBytes);
            }
        } catch (CameraAccessException
                | SecurityException e) { // another app has it, or the permission was just taken back
            throw new IOException("the camera cannot be used: " + e.getMessage(), e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IOException("the boat ends", e);
        }
    }

    private static Optional<String> choose(CameraManager cameras) throws CameraAccessException {
        String[] all = cameras.getCameraIdList();
        for (String id : all) {
            Integer facing = cameras.getCameraCharacteristics(id).get(CameraCharacteristics.LENS_FACING);
            if (facing != null && facing == CameraCharacteristics.LENS_FACING_BACK) {
                return Optional.of(id);
            }
        }
        return all.length == 0 ? Optional.empty() : Optional.of(all[0]);
    }

    /** The largest size up to {@link #LONGEST_SIDE}; where all are larger, the smallest. */
    private static Size size(CameraCharacteristics camera) throws IOException {
        StreamConfigurationMap map = camera.get(CameraCharacteristics.SCALER_STREAM_CONFIGURATION_MAP);
        Size[] sizes = map == null ? null : map.getOutputSizes(ImageFormat.JPEG);
        if (sizes == null || sizes.length == 0) {
            throw new IOException("the camera gives no JPEG pictures");
        }
        Arrays.sort(sizes, (a, b) -> Long.compare(pixels(a), pixels(b)));
        Size chosen = sizes[0];
        for (Size each : sizes) {
            if (Math.max(each.getWidth(), each.getHeight()) <= LONGEST_SIDE) {
                chosen = each;
            }
        }
        return chosen;
    }

    private static long pixels(Size size) {
        return (long) size.getWidth() * size.getHeight();
    }
}
