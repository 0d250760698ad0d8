package org.sami.boat.app.screen;

import android.app.Activity;
import android.content.Intent;
import android.os.Bundle;
import android.os.Handler;
import android.os.Looper;
import android.view.View;
import android.view.WindowManager;
import android.widget.RadioButton;
import android.widget.TextView;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sami.boat.app.R;
import org.sami.boat.app.boat.BoatOnPhone;
import org.sami.boat.link.Role;
import org.sami.boat.link.security.PairingCode;
import org.sami.boat.link.security.Peer;

/**
 * Opened by a link {@code sami-boat://pair/CODE}, which the page of {@code crw phone} makes of the code that a base shows. It names the base and asks a person;
 * only then it calls the base, and hands over to {@link PairActivity} for the check code. Any app and page can open it: without a press nothing happens.
 */
public final class BaseCodeActivity extends Activity {
    private final Handler main = new Handler(Looper.getMainLooper());
    private final ServiceLink service = new ServiceLink(this, this::show);
    private Optional<PairingCode> code = Optional.empty();
    private boolean calls;
    private String wrong = "";

    @Override
    protected void onCreate(@Nullable Bundle saved) {
        super.onCreate(saved);
        getWindow().addFlags(WindowManager.LayoutParams.FLAG_SECURE | WindowManager.LayoutParams.FLAG_KEEP_SCREEN_ON);
        setContentView(R.layout.base_code);
        findViewById(R.id.pair).setOnClickListener(view -> call());
        findViewById(R.id.no).setOnClickListener(view -> finish());
        take(getIntent());
    }

    /** Another code was scanned while this one is shown. */
    @Override
    protected void onNewIntent(Intent intent) {
        super.onNewIntent(intent);
        setIntent(intent);
        take(intent);
    }

    private void take(Intent intent) {
        String text = intent.getData() == null ? "" : intent.getData().getLastPathSegment();
        code = Optional.empty();
        wrong = "";
        try {
            code = Optional.of(PairingCode.parse(text == null ? "" : text));
        } catch (IllegalArgumentException e) {
            wrong = getString(R.string.code_failed, e.getMessage());
        }
        show();
    }

    @Override
    protected void onStart() {
        super.onStart();
        service.open();
    }

    @Override
    protected void onStop() {
        service.close();
        super.onStop();
    }

    private void call() {
        if (!code.isPresent() || !service.boat().isPresent() || calls) {
            return;
        }
        PairingCode asked = code.get();
        BoatOnPhone boat = service.boat().get();
        Role granted = ((RadioButton) findViewById(R.id.observer)).isChecked() ? Role.OBSERVER : Role.COMMANDER;
        calls = true;
        wrong = "";
        show();
        Thread thread = new Thread(() -> call(boat, asked, granted), "base-call");
        thread.setDaemon(true);
        thread.start();
    }

    private void call(BoatOnPhone boat, PairingCode asked, Role granted) {
        try {
            boat.keys().call(asked, granted);
            main.post(this::proved);
        } catch (IOException e) {
            main.post(() -> failed(String.valueOf(e.getMessage())));
        }
    }

    private void proved() {
        calls = false;
        if (!isDestroyed()) {
            startActivity(new Intent(this, PairActivity.class)); // it shows the check code
            finish();
        }
    }

    private void failed(String why) {
        calls = false;
        wrong = getString(R.string.code_failed, why);
        show();
    }

    private void show() {
        Optional<BoatOnPhone> boat = service.boat();
        boolean asks = code.isPresent() && boat.isPresent() && !calls;
        text(R.id.state).setText(state(boat));
        text(R.id.others).setText(code.isPresent() && boat.isPresent() ? others(boat.get(), code.get()) : "");
        text(R.id.wrong).setText(wrong);
        visible(R.id.choice, asks);
        visible(R.id.pair, asks);
    }

    private String state(Optional<BoatOnPhone> boat) {
        if (!code.isPresent()) {
            return "";
        }
        if (!boat.isPresent()) {
            return service.fault().isEmpty() ? getString(R.string.code_waits) : service.fault();
        }
        PairingCode base = code.get();
        return calls
                ? getString(R.string.code_calls, base.boatName())
                : getString(
                        R.string.code_ask,
                        base.boatName(),
                        base.address(),
                        boat.get().settings().name(),
                        base.key().shortText());
    }

    private String others(BoatOnPhone boat, PairingCode base) {
        List<String> names = new ArrayList<>();
        for (Peer each : boat.keys().bases()) {
            if (each.fingerprint().equals(base.key())) {
                return getString(R.string.code_again);
            }
            names.add(each.name());
        }
        return names.isEmpty() ? "" : getString(R.string.code_others, String.join(", ", names));
    }

    private void visible(int id, boolean shown) {
        findViewById(id).setVisibility(shown ? View.VISIBLE : View.GONE);
    }

    private TextView text(int id) {
        return findViewById(id);
    }
}
